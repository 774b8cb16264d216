#include "protocol/slot_merge.h"

#include <algorithm>
#include <cstddef>

namespace hazer::protocol {
namespace {

// The loops below have no branch, so that the compiler does 16 slots or more at a time.

// All bits where the condition holds, else none.
std::uint8_t maskOf(bool condition) {
    return static_cast<std::uint8_t>(-static_cast<int>(condition));
}

struct Slot {
    std::uint8_t level;
    std::uint8_t priority;
};

template <bool kByLatest>
std::uint8_t winner(Slot standing, Slot coming) {
    const std::uint8_t ofEquals = kByLatest ? coming.level : std::max(standing.level, coming.level);
    const std::uint8_t isHigher = maskOf(coming.priority > standing.priority);
    const std::uint8_t isEqual = maskOf(coming.priority == standing.priority);
    const std::uint8_t isLower = maskOf(coming.priority < standing.priority);
    return static_cast<std::uint8_t>((coming.level & isHigher) | (ofEquals & isEqual) |
                                     (standing.level & isLower));
}

template <bool kByLatest>
void addWithOnePriority(const Contribution& contribution, Slots& out, Slots& priorities) {
    const std::uint8_t priority = contribution.priority;
    const std::uint8_t* const levels = contribution.levels.data();
    const std::size_t count = contribution.levels.size();
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = winner<kByLatest>({out[i], priorities[i]}, {levels[i], priority});
        priorities[i] = std::max(priorities[i], priority);
    }
}

template <bool kByLatest>
void addWithSlotPriorities(const Contribution& contribution, Slots& out, Slots& priorities) {
    const std::uint8_t* const own = contribution.slotPriorities->data();
    const std::uint8_t* const levels = contribution.levels.data();
    const std::size_t count = contribution.levels.size();
    for (std::size_t i = 0; i < count; ++i) {
        const auto level = static_cast<std::uint8_t>(levels[i] & maskOf(own[i] != 0));
        out[i] = winner<kByLatest>({out[i], priorities[i]}, {level, own[i]});
        priorities[i] = std::max(priorities[i], own[i]);
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
