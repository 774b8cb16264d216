#include "protocol/pattern.h"

#include <cmath>
#include <numbers>

namespace hazer::protocol {
namespace {

constexpr std::size_t kChaseSpacingSlots = 8;
constexpr double kChaseStepsHz = 8.0;
constexpr double kSineWaveSlots = 16.0;
constexpr double kSineHz = 0.5;
constexpr double kStrobeHz = 5.0;
constexpr std::uint8_t kFullLevel = 255;

// The part of a cycle that has passed, 0..1, for any sign of x.
double cycleFraction(double x) {
    return x - std::floor(x);
}

void fillChase(double timeS, Slots& slots) {
    const double roundFraction = cycleFraction(timeS * kChaseStepsHz / kChaseSpacingSlots);
    const auto litSlot = static_cast<std::size_t>(roundFraction * kChaseSpacingSlots) % kChaseSpacingSlots;
    for (std::size_t i = 0; i < slots.size(); ++i) {
        slots[i] = i % kChaseSpacingSlots == litSlot ? kFullLevel : 0;
    }
}

void fillSine(double timeS, Slots& slots) {
    for (std::size_t i = 0; i < slots.size(); ++i) {
        const double cycle = cycleFraction(timeS * kSineHz - static_cast<double>(i) / kSineWaveSlots);
        const double level = 0.5 + 0.5 * std::sin(2.0 * std::numbers::pi * cycle);
        slots[i] = static_cast<std::uint8_t>(std::lround(level * kFullLevel));
    }
}

}  // namespace

void fillPattern(Pattern pattern, double timeS, Slots& slots) {
    switch (pattern) {
        case Pattern::kChase:
            fillChase(timeS, slots);
            return;
        case Pattern::kSine:
            fillSine(timeS, slots);
            return;
        case Pattern::kStrobe:
            slots.fill(cycleFraction(timeS * kStrobeHz) < 0.5 ? kFullLevel : 0);
            return;
        case Pattern::kFull:
            slots.fill(kFullLevel);
            return;
    }
}

std::optional<Pattern> patternFromName(std::string_view name) {
    if (name == "chase") return Pattern::kChase;
    if (name == "sine") return Pattern::kSine;
    if (name == "strobe") return Pattern::kStrobe;
    if (name == "full") return Pattern::kFull;
    return std::nullopt;
}

}  // namespace hazer::protocol
