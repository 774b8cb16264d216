// DMX frames from the plain serial port of an "Open DMX" interface: where a break was, a frame begins.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "protocol/usb/enttec_widget_data.h"
#include "protocol/usb/ftdi_stream.h"

namespace hazer::protocol {

/// An FTDI chip tells a break by a flag of the USB packet and a character 0, the packet's last. The flag may
/// stay up for one packet more, and zeros are what dark slots are made of; so a break that comes one packet
/// after another has to prove itself, and a frame of a length that is new has to come twice. Allocates
/// nothing.
class OpenDmxFrames {
 public:
    struct Counters {
        std::uint64_t frames = 0;      ///< Given out.
        std::uint64_t otherCodes = 0;  ///< Frames with another start code than 0.
        std::uint64_t broken = 0;      ///< Frames that lost bytes on the way.
        std::uint64_t doubtful = 0;    ///< Frames of a length that had not been seen lately.
    };

    /// Takes the next packet. Gives the 0..512 slots of a frame that it made whole; they stay valid until the
    /// next call.
    std::optional<std::span<const std::uint8_t>> receive(const FtdiPacket& packet);

    /// Bytes were lost: whatever was begun is dropped, up to the next break.
    void interrupt();

    const Counters& counters() const { return counters_; }

    /// Whether anything has come between two breaks.
    bool hasHeardDmx() const {
        return counters_.frames + counters_.otherCodes + counters_.broken + counters_.doubtful > 0;
    }

 private:
    using Frame = std::optional<std::span<const std::uint8_t>>;

    Frame takeBreak(std::span<const std::uint8_t> payload);
    Frame append(std::span<const std::uint8_t> bytes);
    Frame finish();
    void begin();
    bool isKnownLength(std::size_t size);

    static constexpr std::size_t kRememberedLengths = 8;

    std::array<std::uint8_t, kFrameSize> frame_{};
    std::size_t size_ = 0;
    bool isCollecting_ = false;  ///< Between a break and the last slot.
    bool isBroken_ = false;
    int breaksInARow_ = 0;  ///< Packets up to the last one that each ended with a break, or seemed to.
    std::array<std::size_t, kRememberedLengths> lengths_{};
    std::size_t nextLength_ = 0;
    Counters counters_;
};

}  // namespace hazer::protocol
