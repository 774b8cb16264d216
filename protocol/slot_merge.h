// Levels of several sources become those of one universe: priorities first, then highest or latest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "protocol/dmx.h"
#include "protocol/universe_merger.h"

namespace hazer::protocol {

/// What one source brings into a universe.
struct Contribution {
    std::span<const std::uint8_t> levels{};  ///< 0..512; slots beyond are not controlled.
    std::uint8_t priority = 1;               ///< 1..200, of every slot, if slotPriorities is null.
    const Slots* slotPriorities = nullptr;   ///< 0 = not controlled, 1..200.
};

/// Slot by slot, the contributions of the highest priority win: by the highest of their levels, or
/// (kLatest) by the last of them in `contributions`. Slots that nobody controls become 0. Sources: ANSI
/// E1.31-2018 section 6.2.3 for priorities; ETC's per-address priority for slotPriorities.
void mergeSlots(std::span<const Contribution> contributions, MergeMode mode, Slots& out);

}  // namespace hazer::protocol
