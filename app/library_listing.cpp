#include "app/library_listing.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <stdexcept>
#include <string_view>

#include "app/fixture_library.h"
#include "app/nearest_name.h"
#include "fixtures/attribute.h"
#include "fixtures/channel_functions.h"
#include "fixtures/gdtf.h"

namespace hazer::app {
namespace {

using fixtures::AttributeKind;
using Json = nlohmann::ordered_json;

struct Ability {
    AttributeKind kind;
    std::string_view words;
};

/// In the order in which they are told. {} is how many there are of them.
constexpr std::array kAbilities{Ability{AttributeKind::kDimmer, "dimmer"},
                                Ability{AttributeKind::kPan, "pan and tilt"},
                                Ability{AttributeKind::kTilt, "tilt"},
                                Ability{AttributeKind::kPanRotate, "endless rotation"},
                                Ability{AttributeKind::kPlace, "flies"},
                                Ability{AttributeKind::kTurn, "turns"},
                                Ability{AttributeKind::kScale, "changes its size"},
                                Ability{AttributeKind::kStrobe, "strobe"},
                                Ability{AttributeKind::kStrobeMode, "strobe with {} kinds of flashes"},
                                Ability{AttributeKind::kZoom, "zoom"},
                                Ability{AttributeKind::kFocus, "focus"},
                                Ability{AttributeKind::kFocusDistance, "focus in metres"},
                                Ability{AttributeKind::kIris, "iris"},
                                Ability{AttributeKind::kFrost, "{} frosts"},
                                Ability{AttributeKind::kColorAdd, "{} colours of LEDs"},
                                Ability{AttributeKind::kColorRgb, "RGB"},
                                Ability{AttributeKind::kColorSub, "CMY"},
                                Ability{AttributeKind::kHue, "hue and saturation"},
                                Ability{AttributeKind::kCto, "CTO"},
                                Ability{AttributeKind::kCtb, "CTB"},
                                Ability{AttributeKind::kCtc, "colour temperature"},
                                Ability{AttributeKind::kTint, "tint"},
                                Ability{AttributeKind::kColorWheel, "{} colour wheels"},
                                Ability{AttributeKind::kColorMacro, "colour macros"},
                                Ability{AttributeKind::kGoboWheel, "{} gobo wheels"},
                                Ability{AttributeKind::kGoboPos, "turning gobos"},
                                Ability{AttributeKind::kAnimation, "animation wheel"},
                                Ability{AttributeKind::kPrism, "prism"},
                                Ability{AttributeKind::kBladeSoft, "barn doors"},
                                Ability{AttributeKind::kBladeA, "{} framing blades"},
                                Ability{AttributeKind::kBeamShaper, "oval beam"},
                                Ability{AttributeKind::kFog, "fog"},
                                Ability{AttributeKind::kHaze, "haze"},
                                Ability{AttributeKind::kFan, "fan"}};

/// The attributes of the first mode, each once.
std::set<std::string> attributesOf(const fixtures::FixtureType& type) {
    std::set<std::string> attributes;
    if (type.modes.empty()) return attributes;
    for (const fixtures::DmxChannel& channel : type.modes.front().channels) {
        for (const fixtures::ChannelFunction* function : fixtures::functionsOf(channel)) {
            attributes.insert(function->attribute);
        }
    }
    return attributes;
}

struct Light {
    int beams = 0;
    double fluxLm = 0.0;
};

Light lightOf(const fixtures::Geometry& geometry) {
    Light light;
    const bool isLamp =
        geometry.kind == fixtures::GeometryKind::kBeam || geometry.kind == fixtures::GeometryKind::kLaser;
    if (isLamp) light = {1, geometry.beam.luminousFluxLm};
    for (const fixtures::Geometry& child : geometry.children) {
        const Light below = lightOf(child);
        light.beams += below.beams;
        light.fluxLm += below.fluxLm;
    }
    return light;
}

std::string lightInWords(const Light& light) {
    if (light.beams == 0) return "none";
    if (light.beams == 1) return fmt::format("{:.0f} lm", light.fluxLm);
    return fmt::format("{} x {:.0f} lm", light.beams, light.fluxLm / light.beams);
}

std::string modesInWords(const fixtures::FixtureType& type) {
    std::vector<std::string> modes;
    for (const fixtures::DmxMode& mode : type.modes) {
        modes.push_back(fmt::format("{}: {}", mode.name, mode.footprint));
    }
    return fmt::format("{}", fmt::join(modes, ", "));
}

/// One of a kind is told without a number: "a gobo wheel" is "gobo wheel".
std::string inWords(std::string_view words, std::size_t count) {
    if (words.find("{}") == std::string_view::npos) return std::string(words);
    if (count != 1) return fmt::format(fmt::runtime(words), count);
    std::string one(words.substr(words.find("{}") + 3));
    if (one.ends_with('s')) one.pop_back();
    return one;
}

}  // namespace

std::vector<LibraryEntry> readLibrary(const std::vector<std::string>& folders) {
    std::vector<LibraryEntry> library;
    for (const std::string& folder : folders.empty() ? libraryFixtures() : folders) {
        const std::optional<std::filesystem::path> found = findLibraryFixture(folder);
        if (!found) {
            throw std::runtime_error(fmt::format("there is no fixture '{}' in hazer's library.{}", folder,
                                                 suggestName(folder, libraryFixtures())));
        }
        library.push_back({folder, fixtures::loadGdtf(*found)});
    }
    return library;
}

std::vector<std::string> abilitiesOf(const fixtures::FixtureType& type) {
    std::vector<std::string> abilities;
    const std::set<std::string> attributes = attributesOf(type);
    const auto countOf = [&attributes](AttributeKind kind) {
        return static_cast<std::size_t>(std::ranges::count_if(
            attributes, [kind](const std::string& name) { return fixtures::attributeKind(name) == kind; }));
    };
    for (const Ability& ability : kAbilities) {
        const std::size_t count = countOf(ability.kind);
        const bool isTold =
            (ability.kind == AttributeKind::kTilt && countOf(AttributeKind::kPan) > 0) ||
            (ability.kind == AttributeKind::kBladeA && countOf(AttributeKind::kBladeSoft) > 0);
        if (count > 0 && !isTold) abilities.push_back(inWords(ability.words, count));
    }
    return abilities;
}

nlohmann::ordered_json describeLibrary(const std::vector<LibraryEntry>& library) {
    Json all = Json::array();
    for (const LibraryEntry& entry : library) {
        Json modes = Json::array();
        for (const fixtures::DmxMode& mode : entry.type->modes) {
            const Light light = lightOf(mode.geometry);
            modes.push_back({{"name", mode.name},
                             {"slots", mode.footprint},
                             {"beams", light.beams},
                             {"flux_lm", light.fluxLm}});
        }
        all.push_back({{"folder", entry.folder},
                       {"name", entry.type->name},
                       {"manufacturer", entry.type->manufacturer},
                       {"modes", std::move(modes)},
                       {"can", abilitiesOf(*entry.type)}});
    }
    return all;
}

std::string summarizeLibrary(const std::vector<LibraryEntry>& library) {
    std::string text = fmt::format("{:<16} {:<28} {:<15} can\n", "fixture", "modes: slots", "light");
    for (const LibraryEntry& entry : library) {
        text += fmt::format("{:<16} {:<28} {:<15} {}\n", entry.folder, modesInWords(*entry.type),
                            lightInWords(lightOf(entry.type->modes.front().geometry)),
                            fmt::join(abilitiesOf(*entry.type), ", "));
    }
    return text;
}

std::string libraryPage(const std::vector<LibraryEntry>& library, const std::string& pictureFolder) {
    std::string text =
        "# The fixtures that come with hazer\n\n"
        "This page is written by `hazer library --page docs/library.md`, its pictures are drawn by it. A "
        "show names a "
        "fixture by its folder:\n`gdtf = \"moving-spot\"`. How they are made, and how to add one: "
        "[fixtures.md](fixtures.md).\n\n"
        "| | fixture | modes: slots | light | can |\n|---|---|---|---|---|\n";
    for (const LibraryEntry& entry : library) {
        text +=
            fmt::format("| ![{0}]({1}/{0}.png) | `{0}` | {2} | {3} | {4} |\n", entry.folder, pictureFolder,
                        modesInWords(*entry.type), lightInWords(lightOf(entry.type->modes.front().geometry)),
                        fmt::join(abilitiesOf(*entry.type), ", "));
    }
    return text;
}

}  // namespace hazer::app
