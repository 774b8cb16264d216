#include "app/window_faders.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "fixtures/attribute.h"
#include "fixtures/channel_functions.h"
#include "fixtures/channel_value.h"

namespace hazer::app {
namespace {

using fixtures::AttributeKind;

/// What all attributes of a kind share.
struct FaderKind {
    AttributeKind kind;
    FaderGroup group;
    std::string_view label;  ///< Empty: each attribute has its own.
    std::string_view unit;
};

constexpr std::array kFaderKinds{
    FaderKind{AttributeKind::kDimmer, FaderGroup::kIntensity, "dimmer", "%"},
    FaderKind{AttributeKind::kShutter, FaderGroup::kIntensity, "shutter", "%"},
    FaderKind{AttributeKind::kStrobe, FaderGroup::kIntensity, "strobe", "Hz"},
    FaderKind{AttributeKind::kPan, FaderGroup::kPosition, "pan", "deg"},
    FaderKind{AttributeKind::kTilt, FaderGroup::kPosition, "tilt", "deg"},
    FaderKind{AttributeKind::kPanRotate, FaderGroup::kPosition, "pan spin", "deg/s"},
    FaderKind{AttributeKind::kTiltRotate, FaderGroup::kPosition, "tilt spin", "deg/s"},
    FaderKind{AttributeKind::kZoom, FaderGroup::kBeam, "zoom", "deg"},
    FaderKind{AttributeKind::kFocus, FaderGroup::kBeam, "focus", "%"},
    FaderKind{AttributeKind::kIris, FaderGroup::kBeam, "iris", "%"},
    FaderKind{AttributeKind::kFrost, FaderGroup::kBeam, "frost", "%"},
    FaderKind{AttributeKind::kPrism, FaderGroup::kBeam, "prism", ""},
    FaderKind{AttributeKind::kPrismPos, FaderGroup::kBeam, "prism angle", "deg"},
    FaderKind{AttributeKind::kPrismPosRotate, FaderGroup::kBeam, "prism spin", "deg/s"},
    FaderKind{AttributeKind::kBladeA, FaderGroup::kBeam, "", "%"},
    FaderKind{AttributeKind::kBladeB, FaderGroup::kBeam, "", "%"},
    FaderKind{AttributeKind::kBladeRot, FaderGroup::kBeam, "", "deg"},
    FaderKind{AttributeKind::kShaperRot, FaderGroup::kBeam, "frame angle", "deg"},
    FaderKind{AttributeKind::kAnimation, FaderGroup::kGobo, "animation", ""},
    FaderKind{AttributeKind::kAnimationPos, FaderGroup::kGobo, "animation angle", "deg"},
    FaderKind{AttributeKind::kAnimationPosRotate, FaderGroup::kGobo, "animation spin", "deg/s"},
    FaderKind{AttributeKind::kGoboWheel, FaderGroup::kGobo, "gobo", ""},
    FaderKind{AttributeKind::kGoboPos, FaderGroup::kGobo, "gobo angle", "deg"},
    FaderKind{AttributeKind::kGoboPosRotate, FaderGroup::kGobo, "gobo spin", "deg/s"},
    FaderKind{AttributeKind::kColorAdd, FaderGroup::kColor, "", "%"},
    FaderKind{AttributeKind::kColorSub, FaderGroup::kColor, "", "%"},
    FaderKind{AttributeKind::kColorRgb, FaderGroup::kColor, "", "%"},
    FaderKind{AttributeKind::kHue, FaderGroup::kColor, "hue", "deg"},
    FaderKind{AttributeKind::kSaturation, FaderGroup::kColor, "saturation", "%"},
    FaderKind{AttributeKind::kCto, FaderGroup::kColor, "CTO", ""},
    FaderKind{AttributeKind::kCtb, FaderGroup::kColor, "CTB", ""},
    FaderKind{AttributeKind::kCtc, FaderGroup::kColor, "CTC", ""},
    FaderKind{AttributeKind::kColorWheel, FaderGroup::kColor, "colour wheel", ""},
    FaderKind{AttributeKind::kColorMacro, FaderGroup::kEffect, "", ""},
    FaderKind{AttributeKind::kNamed, FaderGroup::kEffect, "", ""},
};

struct ColorLabel {
    std::string_view attribute;
    std::string_view label;
};

constexpr std::array kColorLabels{
    ColorLabel{"ColorAdd_R", "red"},    ColorLabel{"ColorAdd_G", "green"},
    ColorLabel{"ColorAdd_B", "blue"},   ColorLabel{"ColorAdd_W", "white"},
    ColorLabel{"ColorSub_C", "cyan"},   ColorLabel{"ColorSub_M", "magenta"},
    ColorLabel{"ColorSub_Y", "yellow"},
};

std::string labelOf(const FaderKind& kind, const std::string& attribute) {
    if (!kind.label.empty()) {
        const int number = fixtures::attributeOf(attribute).number;
        return number > 1 ? fmt::format("{} {}", kind.label, number) : std::string(kind.label);
    }
    const auto found = std::find_if(kColorLabels.begin(), kColorLabels.end(),
                                    [&](const ColorLabel& label) { return label.attribute == attribute; });
    return found == kColorLabels.end() ? attribute : std::string(found->label);
}

template <typename Matches>
const fixtures::ChannelFunction* findFunction(const fixtures::Fixture& fixture, const Matches& matches) {
    for (const fixtures::DmxChannel& channel : fixture.mode().channels) {
        for (const fixtures::ChannelFunction* function : fixtures::functionsOf(channel)) {
            if (matches(*function)) return function;
        }
    }
    return nullptr;
}

const fixtures::Wheel* wheelOf(const fixtures::Fixture& fixture, const std::string& attribute) {
    const fixtures::ChannelFunction* const onWheel =
        findFunction(fixture, [&attribute](const fixtures::ChannelFunction& function) {
            return function.attribute == attribute && function.wheelIndex >= 0;
        });
    return onWheel == nullptr ? nullptr
                              : &fixture.type().wheels[static_cast<std::size_t>(onWheel->wheelIndex)];
}

std::vector<NamedFaderValue> namesOf(const fixtures::Fixture& fixture, const std::string& attribute) {
    const fixtures::ChannelFunction* const function = findFunction(
        fixture, [&attribute](const auto& candidate) { return candidate.attribute == attribute; });
    std::vector<NamedFaderValue> names;
    if (function == nullptr) return names;
    for (const fixtures::ChannelSet& set : function->sets) {
        const std::uint32_t middle = set.dmxFrom + (set.dmxTo - set.dmxFrom) / 2;
        if (!set.name.empty()) names.push_back({set.name, fixtures::valueAt(*function, middle, 0).physical});
    }
    return names;
}

std::optional<Fader> faderFor(const fixtures::Fixture& fixture, const fixtures::AttributeRange& range) {
    const AttributeKind kind = fixtures::attributeKind(range.attribute);
    const auto found = std::find_if(kFaderKinds.begin(), kFaderKinds.end(),
                                    [&](const FaderKind& candidate) { return candidate.kind == kind; });
    if (found == kFaderKinds.end()) return std::nullopt;
    Fader fader;
    fader.attribute = range.attribute;
    fader.label = labelOf(*found, range.attribute);
    fader.unit = found->unit;
    fader.group = found->group;
    fader.from = std::min(range.physicalFrom, range.physicalTo);
    fader.to = std::max(range.physicalFrom, range.physicalTo);
    if (range.wheelSlotCount > 0) fader.wheel = wheelOf(fixture, range.attribute);
    if (fader.group == FaderGroup::kEffect && fader.wheel == nullptr) {
        fader.names = namesOf(fixture, range.attribute);
    }
    return fader;
}

int firstSlotWhere(const fixtures::Wheel& wheel, bool hasPicture) {
    const int count = static_cast<int>(wheel.slots.size());
    for (int slot = 1; slot <= count; ++slot) {
        if (isGobo(wheel, slot) == hasPicture) return slot;
    }
    return 0;
}

bool hasAttribute(const std::vector<fixtures::AttributeRange>& ranges, std::string_view attribute) {
    return std::any_of(ranges.begin(), ranges.end(),
                       [&](const fixtures::AttributeRange& range) { return range.attribute == attribute; });
}

}  // namespace

std::vector<Fader> fadersOf(const fixtures::Fixture& fixture) {
    std::vector<Fader> faders;
    for (const fixtures::AttributeRange& range : fixture.attributes()) {
        if (std::optional<Fader> fader = faderFor(fixture, range)) faders.push_back(std::move(*fader));
    }
    std::stable_sort(faders.begin(), faders.end(),
                     [](const Fader& a, const Fader& b) { return a.group < b.group; });
    return faders;
}

std::string_view groupName(FaderGroup group) {
    switch (group) {
        case FaderGroup::kIntensity:
            return "Intensity";
        case FaderGroup::kPosition:
            return "Position";
        case FaderGroup::kBeam:
            return "Beam";
        case FaderGroup::kGobo:
            return "Gobo";
        case FaderGroup::kColor:
            return "Colour";
        case FaderGroup::kEffect:
            return "Effects";
    }
    return "";
}

bool isGobo(const fixtures::Wheel& wheel, int slot) {
    if (slot < 1 || slot > static_cast<int>(wheel.slots.size())) return false;
    return wheel.slots[static_cast<std::size_t>(slot - 1)].image != nullptr;
}

int slotAfterGoboSwitch(const fixtures::Wheel& wheel, int slot, int lastGobo) {
    const bool wantsGobo = !isGobo(wheel, slot);
    const int target = wantsGobo && isGobo(wheel, lastGobo) ? lastGobo : firstSlotWhere(wheel, wantsGobo);
    return target == 0 ? slot : target;
}

ColorMixer colorMixerOf(const fixtures::Fixture& fixture) {
    const std::vector<fixtures::AttributeRange> ranges = fixture.attributes();
    for (const ColorMixer& mixer :
         {ColorMixer{ColorMixing::kAdditive, "ColorAdd_R", "ColorAdd_G", "ColorAdd_B"},
          ColorMixer{ColorMixing::kSubtractive, "ColorSub_C", "ColorSub_M", "ColorSub_Y"}}) {
        if (hasAttribute(ranges, mixer.red) && hasAttribute(ranges, mixer.green) &&
            hasAttribute(ranges, mixer.blue)) {
            return mixer;
        }
    }
    return {};
}

double mixerValue(ColorMixing mixing, double share) {
    return mixing == ColorMixing::kSubtractive ? 1.0 - share : share;
}

}  // namespace hazer::app
