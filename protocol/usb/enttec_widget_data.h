// What is inside the messages of an ENTTEC-like interface.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "protocol/dmx.h"

namespace hazer::protocol {

/// A DMX frame with its start code first.
inline constexpr std::size_t kFrameSize = 1 + kSlotCount;

/// Label 5.
struct EnttecDmx {
    bool queueOverflowed = false;  ///< Frames before this one were lost inside the interface.
    bool overrun = false;          ///< Bytes of this frame were lost.
    std::uint8_t startCode = 0;
    std::span<const std::uint8_t> slots{};  ///< 0..512.
};

/// Nothing if there is no start code or more than 512 slots.
std::optional<EnttecDmx> parseEnttecDmx(std::span<const std::uint8_t> data);

/// A frame that only its changes tell (label 9).
class EnttecChanges {
 public:
    /// The frame before the changes: at most 512 slots, the missing ones 0.
    void begin(std::span<const std::uint8_t> slots);

    /// Changes the frame, or leaves it as it is and returns false: the message does not hold as many values
    /// as it says, reaches beyond slot 512, or is of a frame with another start code than 0.
    bool apply(std::span<const std::uint8_t> data);

    const Slots& slots() const { return slots_; }

 private:
    Slots slots_{};
};

/// Label 3.
struct EnttecParameters {
    std::string firmware;  ///< "1.44".
    double breakUs = 0.0;  ///< Of what it sends.
    double markAfterBreakUs = 0.0;
    std::uint8_t framesPerS = 0;  ///< 0: as fast as it can.
};

/// Nothing if it is too short.
std::optional<EnttecParameters> parseEnttecParameters(std::span<const std::uint8_t> data);

/// Label 10: the eight digits that stand on the case. Empty if it has no number; nothing if these are not
/// four bytes.
std::optional<std::string> parseEnttecSerial(std::span<const std::uint8_t> data);

/// Labels 77 and 78.
struct EnttecIdentity {
    std::uint16_t id = 0;  ///< Manufacturer: as ESTA gave it. Device: the manufacturer's own.
    std::string name;      ///< Printable UTF-8; 32 bytes were sent at most.
};

/// Nothing if there is no id.
std::optional<EnttecIdentity> parseEnttecIdentity(std::span<const std::uint8_t> data);

}  // namespace hazer::protocol
