#include "app/stand_in.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <vector>

#include "app/fixture_library.h"
#include "fixtures/text.h"

namespace hazer::app {
namespace {

using fixtures::DmxMode;

constexpr const char* kSpot = "moving-spot";
constexpr const char* kWash = "moving-wash";
constexpr const char* kBeam = "moving-beam";
constexpr const char* kPar = "par-rgbw";
constexpr const char* kBlinder = "blinder";
constexpr const char* kProfile = "moving-profile";
constexpr const char* kScanner = "scanner";
constexpr const char* kStrobe = "strobe";
constexpr const char* kConventional = "fresnel";

/// Fewer slots than these do not move a head.
constexpr int kFewestSlotsOfHead = 8;

/// A part of a fixture's name, in lower case, and what it tells.
struct Word {
    std::string_view text;
    const char* standIn;
    bool beginsWord;  ///< "par" is no sign of a par in "sparkle".
};

// The first that fits counts: a "BeamWash" is a wash.
constexpr std::array kWords{Word{"strobe", kStrobe, false},
                            Word{"blinder", kBlinder, false},
                            Word{"sunstrip", kBlinder, false},
                            Word{"molefay", kBlinder, false},
                            Word{"atomic", kStrobe, true},
                            Word{"fresnel", kConventional, false},
                            Word{"source four", kConventional, false},
                            Word{"source 4", kConventional, false},
                            Word{"pendant", kConventional, false},
                            Word{"dimmer", kConventional, true},
                            Word{"wash", kWash, false},
                            Word{"spiider", kWash, false},
                            Word{"aura", kWash, true},
                            Word{"spot", kSpot, false},
                            Word{"profile", kProfile, false},
                            Word{"pointe", kSpot, false},
                            Word{"esprite", kProfile, false},
                            Word{"viper", kProfile, false},
                            Word{"scan", kScanner, true},
                            Word{"beam", kBeam, false},
                            Word{"sharpy", kBeam, false},
                            Word{"par", kPar, true},
                            Word{"led", kPar, true},
                            Word{"bar", kPar, true},
                            Word{"batten", kPar, true},
                            Word{"flood", kPar, false},
                            Word{"cyc", kPar, true}};

bool occurs(const Word& word, std::string_view name) {
    for (std::size_t at = name.find(word.text); at != std::string_view::npos;
         at = name.find(word.text, at + 1)) {
        if (!word.beginsWord || at == 0 || std::isalpha(static_cast<unsigned char>(name[at - 1])) == 0)
            return true;
    }
    return false;
}

bool movesHead(std::string_view standIn) {
    constexpr std::array<std::string_view, 5> kHeads{kSpot, kProfile, kWash, kBeam, kScanner};
    return std::ranges::find(kHeads, standIn) != kHeads.end();
}

/// All attributes of a mode, in lower case.
std::set<std::string> attributesOf(const DmxMode& mode) {
    std::set<std::string> attributes;
    for (const fixtures::DmxChannel& channel : mode.channels) {
        for (const fixtures::LogicalChannel& logical : channel.logicalChannels) {
            attributes.insert(fixtures::lowerCased(logical.attribute));
        }
    }
    return attributes;
}

bool hasAny(const std::set<std::string>& attributes, std::string_view beginning) {
    return std::ranges::any_of(attributes, [&](const std::string& a) { return a.starts_with(beginning); });
}

/// Programs number their placeholders "Dimmer1", "Dimmer2" ...
bool isMeaningless(const std::string& attribute) {
    if (attribute == "dummy" || attribute == "nofeature") return true;
    std::string_view rest = attribute;
    if (!rest.starts_with("dimmer")) return false;
    rest.remove_prefix(6);
    return !rest.empty() && std::ranges::all_of(rest, [](char c) { return c >= '0' && c <= '9'; });
}

bool isOfLight(const std::string& attribute) {
    constexpr std::array<std::string_view, 6> kBeginnings{"dimmer", "color",   "gobo",
                                                          "zoom",   "shutter", "iris"};
    return std::ranges::any_of(kBeginnings, [&](std::string_view b) { return attribute.starts_with(b); });
}

bool hasBeam(const fixtures::Geometry& geometry) {
    const bool isBeam =
        geometry.kind == fixtures::GeometryKind::kBeam || geometry.kind == fixtures::GeometryKind::kLaser;
    return isBeam || std::ranges::any_of(geometry.children, hasBeam);
}

// Empty where the attributes mean nothing.
std::string byAttributes(const DmxMode& mode) {
    const std::set<std::string> attributes = attributesOf(mode);
    if (attributes.contains("pan") || attributes.contains("tilt")) {
        if (hasAny(attributes, "coloradd")) return kWash;
        return hasAny(attributes, "gobo") || !hasAny(attributes, "color") ? kSpot : kBeam;
    }
    return hasAny(attributes, "coloradd") || hasAny(attributes, "colorrgb") ? kPar : "";
}

std::string bySlots(int slots) {
    if (slots >= 10) return kSpot;
    return slots >= 3 ? kPar : kConventional;
}

}  // namespace

bool isDummy(const DmxMode& mode) {
    const std::set<std::string> attributes = attributesOf(mode);
    if (attributes.empty()) return false;
    if (hasBeam(mode.geometry)) {
        return std::ranges::all_of(attributes,
                                   [](const std::string& a) { return a == "dummy" || a == "nofeature"; });
    }
    return std::ranges::all_of(attributes, isMeaningless) || std::ranges::any_of(attributes, isOfLight);
}

std::string standInFor(std::string_view name, const DmxMode* mode) {
    const int slots = mode == nullptr ? 0 : mode->footprint;
    if (mode != nullptr) {
        if (std::string found = byAttributes(*mode); !found.empty()) return found;
    }
    const std::string lower = fixtures::lowerCased(name);
    for (const Word& word : kWords) {
        const bool isTooSmall = movesHead(word.standIn) && slots > 0 && slots < kFewestSlotsOfHead;
        if (!isTooSmall && occurs(word, lower)) return word.standIn;
    }
    return bySlots(slots);
}

const DmxMode* modeFitting(const fixtures::FixtureType& type, int slots) {
    const DmxMode* best = nullptr;
    for (const DmxMode& mode : type.modes) {
        if (slots <= 0) return &mode;
        const bool isBetter = best == nullptr || mode.footprint > best->footprint;
        if (mode.footprint <= slots && isBetter) best = &mode;
    }
    return best;
}

std::string smallestStandIn() {
    return kConventional;
}

}  // namespace hazer::app
