// One source of one universe, as the merger remembers it.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "protocol/deep_ptr.h"
#include "protocol/dmx.h"
#include "protocol/rate_meter.h"
#include "protocol/universe_merger.h"
#include "protocol/universe_status.h"

namespace hazer::protocol {

class MergedUniverse;

/// How long a source may be silent before it is lost: Art-Net 4 (merging) 10 s, E1.31 section 6.7.1 2.5 s,
/// E1.11 (receivers) 1.25 s.
std::chrono::milliseconds lossTime(Transport transport);

/// What was last sent with the levels, or in their stead.
struct PacketLevels {
    Slots slots{};
    std::uint16_t slotCount = 0;
    std::uint8_t priority = kDefaultPriority;  ///< 0..200.
    bool isPreview = false;

    void take(const Levels& levels);
};

/// Levels that wait for their synchronization packet.
struct HeldLevels {
    PacketLevels levels;
    std::uint64_t changeNumber = 0;  ///< As that of the source, when they arrived.
    SyncGroup group{};
    std::size_t place = 0;  ///< In the list of SyncGroups.
    bool isWaiting = false;
};

struct SlotPriorities {
    Slots slots{};
    TimePoint lastReceived{};
    bool isValid = false;  ///< Came, and has not been given up since.
};

struct MergeSource {
    MergeSource(MergedUniverse& universe, const SourceId& sourceId) : owner(&universe), id(sourceId) {}

    /// What is empty stays as it was; what is long is cut.
    void describe(std::string_view newName, std::string_view newAddress);

    std::chrono::milliseconds lossTime() const { return protocol::lossTime(id.transport); }
    /// When it is lost unless it is heard again.
    TimePoint lossDue() const { return lastLevels + lossTime(); }
    bool hasPriorities() const { return priorities && priorities->isValid; }
    bool isHolding() const { return held && held->isWaiting; }

    MergedUniverse* owner;
    SourceId id;
    std::string name;
    std::string address;
    PacketLevels levels;
    DeepPtr<HeldLevels> held;            ///< Null until it first has to wait.
    DeepPtr<SlotPriorities> priorities;  ///< Null until it first sends some.
    bool isAlive = false;                ///< Levels came, and it was not lost since.
    bool isShown = false;                ///< Alive, and its levels have been shown since it came.
    bool isOverdue = false;  ///< Silent for its loss time; given up when the others are decided, too.
    bool isWaiting = false;  ///< In its sampling period: counts only if nobody else does.
    bool isSynchronized = false;
    TimePoint lastLevels{};
    TimePoint waitsUntil{};
    std::uint64_t changeNumber = 0;  ///< Grows with every change of levels in the universe, for kLatest.
    std::uint64_t packetCount = 0;
    std::uint64_t lateCount = 0;
    std::uint64_t lossCount = 0;
    RateMeter rate;
};

}  // namespace hazer::protocol
