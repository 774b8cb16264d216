// What has arrived, universe by universe. The receiver writes, a frame takes one consistent set.
#pragma once

#include <mutex>
#include <span>

#include "protocol/dmx.h"
#include "protocol/universe_status.h"

namespace hazer::protocol {

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
