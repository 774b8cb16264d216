// The Nodle U1, Nodle R4S, FX5 and Digital Enlightenment's USB-DMX: HID devices that tell a universe in 16
// reports of 33 bytes, the number of the block first (as the makers' published examples have it).
#pragma once

#include "protocol/usb/usb_widget.h"

namespace hazer::protocol {

class NodleWidget : public UsbWidget {
 public:
    void receive(std::span<const std::uint8_t> transfer, TimePoint now, const ShowSlots& show) override;
    /// Once: "pass what you hear on to the computer".
    std::vector<std::uint8_t> takeRequest(TimePoint now) override;
    std::optional<TimePoint> nextDeadline() const override;
    void interrupt() override {}  // every report stands for itself
    UsbWidgetFacts facts() const override { return facts_; }

 private:
    Slots slots_{};
    bool isStarted_ = false;
    UsbWidgetFacts facts_{.kind = "Nodle"};
};

}  // namespace hazer::protocol
