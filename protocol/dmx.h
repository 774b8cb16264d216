// The words of DMX that the whole protocol module shares. No code but comparisons.
#pragma once

#include <array>
#include <chrono>
#include <compare>
#include <cstddef>
#include <cstdint>

namespace hazer::protocol {

/// Slots of one DMX512 universe (ANSI E1.11, start code excluded).
inline constexpr std::size_t kSlotCount = 512;

/// The values of one universe. Index 0 is what people call slot 1.
using Slots = std::array<std::uint8_t, kSlotCount>;

/// Time is always an argument, so that a replay is exact and a test needs no sleep.
using Clock = std::chrono::steady_clock;
using TimePoint = Clock::time_point;

enum class Transport : std::uint8_t {
    kArtNet,
    kSacn,
    kDmx,  ///< A plain DMX line: a USB interface, or a file that knows of no network.
    kAny,  ///< Only in a patch: the same number on all of the others, merged.
};

/// A universe under the name its network gives it: an Art-Net Port-Address 0..32767, an sACN
/// universe 1..63999, or the number of a DMX line from 1.
struct UniverseId {
    Transport transport = Transport::kArtNet;
    std::uint16_t number = 0;
    auto operator<=>(const UniverseId&) const = default;
};

}  // namespace hazer::protocol
