// What is behind an FTDI chip: an interface that speaks ENTTEC's DMX USB Pro protocol, or a bare serial port
// that hears DMX ("Open DMX"). They share USB ids, so it has to be found out.
#pragma once

#include "protocol/usb/enttec_message.h"
#include "protocol/usb/enttec_widget_data.h"
#include "protocol/usb/open_dmx_frames.h"
#include "protocol/usb/usb_widget.h"

namespace hazer::protocol {

/// Listens first: breaks tell a bare port, and messages a Pro, which by itself sends what it hears. Only
/// where there is silence does it ask, since what is written to a bare port might go out onto the DMX line.
/// Where nobody answers, it takes the port for a bare one, until a message proves otherwise.
class FtdiWidget : public UsbWidget {
 public:
    /// `packetSize`: the endpoint's wMaxPacketSize, 64 or 512.
    FtdiWidget(std::size_t packetSize, TimePoint now);

    void receive(std::span<const std::uint8_t> transfer, TimePoint now, const ShowSlots& show) override;
    std::vector<std::uint8_t> takeRequest(TimePoint now) override;
    std::optional<TimePoint> nextDeadline() const override;
    void interrupt() override;
    UsbWidgetFacts facts() const override;

 private:
    enum class Phase : std::uint8_t {
        kListening,
        kAsking,    ///< Waits for a serial number.
        kStarting,  ///< It is a Pro, which tells of itself and is then put to receiving.
        kPro,
        kOpen,
    };

    void receiveMessages(std::span<const std::uint8_t> bytes, TimePoint now, const ShowSlots& show);
    bool take(const EnttecMessage& message, const ShowSlots& show);
    bool takeDmx(std::span<const std::uint8_t> data, const ShowSlots& show);
    bool takeChanges(std::span<const std::uint8_t> data, const ShowSlots& show);
    void take(const EnttecIdentity& identity, EnttecLabel label);
    void listenTo(const FtdiPacket& packet, const ShowSlots& show);
    void endWait(const EnttecMessage& message, TimePoint now);
    std::vector<std::uint8_t> nextStartRequest(TimePoint now);
    void forgetFrame();
    std::vector<std::uint8_t> askAgain(TimePoint now);
    bool isPro() const { return phase_ == Phase::kStarting || phase_ == Phase::kPro; }

    std::size_t packetSize_;
    Phase phase_ = Phase::kListening;
    TimePoint deadline_;
    int asked_ = 0;
    std::size_t startStep_ = 0;  ///< Requests of the start that were sent.
    EnttecDecoder decoder_;
    EnttecChanges changes_;
    bool knowsFrame_ = false;  ///< What changes_ holds is what the interface holds.
    OpenDmxFrames frames_;
    std::string manufacturer_;
    std::string device_;
    UsbWidgetFacts facts_;  ///< Of a Pro.
};

}  // namespace hazer::protocol
