// One DMX input behind USB, whatever its make: bytes in, frames and requests out. No USB here, and no clock.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "protocol/dmx.h"

namespace hazer::protocol {

/// What an interface says of itself, and what came from it.
struct UsbWidgetFacts {
    std::string kind{};            ///< "DMX USB Pro", "Open DMX", "Nodle"; empty while that is not known.
    std::string name{};            ///< Manufacturer and device, where its own protocol tells them.
    std::string firmware{};        ///< "1.44", where it tells.
    std::string serial{};          ///< The number on its case, where its own protocol tells it.
    std::uint64_t frames = 0;      ///< Taken.
    std::uint64_t otherCodes = 0;  ///< Frames with another start code than 0.
    std::uint64_t lostFrames = 0;  ///< Frames that came with a sign of lost bytes, and were dropped.
    std::uint64_t malformed = 0;   ///< Messages that say what cannot be, and reports of a wrong size.
};

using ShowSlots = std::function<void(std::span<const std::uint8_t> slots)>;

class UsbWidget {
 public:
    virtual ~UsbWidget() = default;

    /// Takes one transfer as it came from the bus, and shows every frame that became whole.
    virtual void receive(std::span<const std::uint8_t> transfer, TimePoint now, const ShowSlots& show) = 0;

    /// What to write to the interface now; empty: nothing.
    virtual std::vector<std::uint8_t> takeRequest(TimePoint now) = 0;

    /// When takeRequest may have something; nothing: only after something was received.
    virtual std::optional<TimePoint> nextDeadline() const = 0;

    /// Bytes were lost: nothing that was begun can be trusted.
    virtual void interrupt() = 0;

    virtual UsbWidgetFacts facts() const = 0;
};

}  // namespace hazer::protocol
