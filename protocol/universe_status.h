// What there is to know about a universe besides its slots: for panels, monitor and inspection.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "protocol/dmx.h"

namespace hazer::protocol {

/// The priority of a source that names none (E1.31 section 6.2.3).
inline constexpr std::uint8_t kDefaultPriority = 100;
inline constexpr std::uint8_t kMaxPriority = 200;

/// Who sends. sACN: the CID. Art-Net: the four bytes of the address, then Physical. DMX: a hash or number of
/// the interface; all else 0.
struct SourceId {
    Transport transport = Transport::kArtNet;
    std::array<std::uint8_t, 16> id{};
    auto operator<=>(const SourceId&) const = default;
};

/// One universe as it stands.
struct Universe {
    Slots slots{};                  ///< Slots that nobody controls are 0.
    std::uint16_t slotCount = 0;    ///< Slots in the longest live source, 0..512.
    std::uint64_t packetCount = 0;  ///< Packets taken since the start.
    TimePoint lastReceived{};
    bool isLost = false;  ///< No source is alive: the look is held or fades out.
};

using UniverseSet = std::map<UniverseId, Universe>;

struct SourceStatus {
    SourceId id{};
    std::string name;     ///< As the source calls itself; may be empty.
    std::string address;  ///< "10.0.0.5", "fe80::1%eth0", or what a USB interface says of itself.
    std::uint8_t priority = kDefaultPriority;
    bool hasSlotPriorities = false;
    bool isAlive = true;
    bool isWinning = false;  ///< At least one slot is this source's.
    bool isPreview = false;
    bool isSynchronized = false;  ///< Its last levels waited for a synchronization packet.
    double packetsPerS = 0.0;     ///< Over the last seconds.
    std::uint64_t packetCount = 0;
    std::uint64_t lateCount = 0;  ///< Out of order, refused.
    std::uint64_t lossCount = 0;  ///< Times it fell silent or left.
    TimePoint lastReceived{};
};

struct UniverseStatus {
    UniverseId universe{};
    bool isAskedFor = false;
    bool isLost = false;
    bool isMerging = false;
    std::uint64_t packetCount = 0;
    std::uint64_t refusedSources = 0;   ///< Packets of sources beyond the limit.
    std::vector<SourceStatus> sources;  ///< Ascending by id; lost ones stay until another needs their place.
    Universe look{};
};

}  // namespace hazer::protocol
