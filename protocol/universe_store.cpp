#include "protocol/universe_store.h"

#include <algorithm>

namespace hazer::protocol {

void UniverseStore::set(UniverseId id, std::span<const std::uint8_t> slots, TimePoint now) {
    const std::size_t count = std::min(slots.size(), kSlotCount);
    const std::lock_guard lock(mutex_);
    Universe& universe = universes_[id];
    std::copy_n(slots.begin(), count, universe.slots.begin());
    std::fill(universe.slots.begin() + static_cast<std::ptrdiff_t>(count), universe.slots.end(),
              std::uint8_t{0});
    universe.slotCount = static_cast<std::uint16_t>(count);
    ++universe.packetCount;
    universe.lastReceived = now;
}

void UniverseStore::latch(UniverseSet& out) const {
    const std::lock_guard lock(mutex_);
    out = universes_;  // libstdc++ and libc++ refill the nodes of the left side before they make new ones
}

}  // namespace hazer::protocol
