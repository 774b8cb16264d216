// What has arrived, universe by universe. The receiver writes, a frame takes one consistent set.
#pragma once

#include <map>
#include <mutex>
#include <span>

#include "protocol/dmx.h"

namespace hazer::protocol {

/// One universe as it stands.
struct Universe {
    Slots slots{};                  ///< Slots beyond slotCount are 0.
    std::uint16_t slotCount = 0;    ///< Slots in the last packet, 1..512.
    std::uint64_t packetCount = 0;  ///< Packets taken since the start.
    TimePoint lastReceived{};
};

using UniverseSet = std::map<UniverseId, Universe>;

/// Thread-safe. Written by receiving threads, read once a frame.
class UniverseStore {
 public:
    /// Replaces the slots of one universe; missing slots become 0 (ETC's merger does the same). `slots`
    /// holds 1..512 values.
    void set(UniverseId id, std::span<const std::uint8_t> slots, TimePoint now);

    /// Copies everything that stands now into `out`, as one consistent set. Reuses the nodes of `out`: once
    /// it holds every universe, a latch does not allocate.
    void latch(UniverseSet& out) const;

 private:
    mutable std::mutex mutex_;
    UniverseSet universes_;
};

}  // namespace hazer::protocol
