// The faders that a fixture has: one for each attribute that changes its light.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fixtures/fixture.h"

namespace hazer::app {

/// Faders of a group stand together, in this order.
enum class FaderGroup : std::uint8_t { kIntensity, kPosition, kBeam, kGobo, kColor, kEffect };

/// A value that has a name in the fixture's file.
struct NamedFaderValue {
    std::string name;
    double value = 0.0;  ///< In the middle of the stretch that has this name.
};

struct Fader {
    std::string attribute;  ///< As GDTF names it.
    std::string label;      ///< As people call it.
    std::string unit;       ///< Such as "deg"; "%" for shares 0..1, empty for wheel slots.
    FaderGroup group = FaderGroup::kIntensity;
    double from = 0.0;  ///< In the units of Fixture::hold; at most `to`.
    double to = 1.0;
    const fixtures::Wheel* wheel =
        nullptr;  ///< Where the values are its slots 1..; lives as long as the fixture.
    std::vector<NamedFaderValue> names;  ///< Where a name is all that the file says of a value.
};

/// In the order in which they are shown. Attributes without effect on the light are left out.
std::vector<Fader> fadersOf(const fixtures::Fixture& fixture);

std::string_view groupName(FaderGroup group);

/// The slot of a gobo wheel, from 1, that stands in the light after "gobo on/off" was pressed: from a gobo to
/// the open slot, from the open slot to `lastGobo` if it is a gobo (0: none), else to the wheel's first gobo.
/// Stays where it is if there is nothing to change to.
int slotAfterGoboSwitch(const fixtures::Wheel& wheel, int slot, int lastGobo);

/// Is there a picture in this slot, from 1, of a wheel?
bool isGobo(const fixtures::Wheel& wheel, int slot);

/// How colour is mixed.
enum class ColorMixing : std::uint8_t { kNone, kAdditive, kSubtractive };

/// Attributes of the three faders that make red, green and blue, or take them away (cyan, magenta, yellow).
struct ColorMixer {
    ColorMixing mixing = ColorMixing::kNone;
    std::string_view red;
    std::string_view green;
    std::string_view blue;
};

/// Additive goes first where a fixture has both.
ColorMixer colorMixerOf(const fixtures::Fixture& fixture);

/// The value of one of a mixer's faders for a share 0..1 of its primary, and back: a flag that is in takes
/// light away.
double mixerValue(ColorMixing mixing, double share);

}  // namespace hazer::app
