#include "protocol/slot_merge.h"

#include <algorithm>
#include <cstddef>

namespace hazer::protocol {
namespace {

// The loops below have no branch for the compiler to stumble over: it does 16 slots or more at a time.

template <bool kByLatest>
std::uint8_t winnerOfEquals(std::uint8_t standing, std::uint8_t coming) {
    return kByLatest ? coming : std::max(standing, coming);
}

template <bool kByLatest>
void addWithOnePriority(const Contribution& contribution, Slots& out, Slots& priorities) {
    const std::uint8_t priority = contribution.priority;
    for (std::size_t i = 0; i < contribution.levels.size(); ++i) {
        const std::uint8_t level = contribution.levels[i];
        const std::uint8_t standing = priorities[i];
        const std::uint8_t equal = winnerOfEquals<kByLatest>(out[i], level);
        out[i] = priority > standing ? level : priority == standing ? equal : out[i];
        priorities[i] = std::max(standing, priority);
    }
}

template <bool kByLatest>
void addWithSlotPriorities(const Contribution& contribution, Slots& out, Slots& priorities) {
    const Slots& own = *contribution.slotPriorities;
    for (std::size_t i = 0; i < contribution.levels.size(); ++i) {
        const std::uint8_t level = own[i] == 0 ? std::uint8_t{0} : contribution.levels[i];
        const std::uint8_t standing = priorities[i];
        const std::uint8_t equal = winnerOfEquals<kByLatest>(out[i], level);
        out[i] = own[i] > standing ? level : own[i] == standing ? equal : out[i];
        priorities[i] = std::max(standing, own[i]);
    }
}

template <bool kByLatest>
void mergeAll(std::span<const Contribution> contributions, Slots& out) {
    out.fill(0);
    Slots priorities{};
    for (const Contribution& contribution : contributions) {
        if (contribution.slotPriorities) {
            addWithSlotPriorities<kByLatest>(contribution, out, priorities);
        } else {
            addWithOnePriority<kByLatest>(contribution, out, priorities);
        }
    }
}

void copyOne(const Contribution& contribution, Slots& out) {
    const auto end = std::copy(contribution.levels.begin(), contribution.levels.end(), out.begin());
    std::fill(end, out.end(), std::uint8_t{0});
}

}  // namespace

void mergeSlots(std::span<const Contribution> contributions, MergeMode mode, Slots& out) {
    if (contributions.size() == 1 && !contributions[0].slotPriorities) {
        copyOne(contributions[0], out);
    } else if (mode == MergeMode::kLatest) {
        mergeAll<true>(contributions, out);
    } else {
        mergeAll<false>(contributions, out);
    }
}

}  // namespace hazer::protocol
