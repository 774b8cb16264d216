#include "app/inspection.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <vector>

#include "app/nearest_name.h"
#include "app/universe_name.h"
#include "fixtures/channel_functions.h"
#include "fixtures/channel_value.h"

namespace hazer::app {
namespace {

using Json = nlohmann::ordered_json;

Json jsonOf(const glm::dvec3& vector) {
    return {vector.x, vector.y, vector.z};
}

/// Slots that each DMX break of a mode takes.
std::map<int, int> footprints(const fixtures::DmxMode& mode) {
    std::map<int, int> slots;
    for (const fixtures::DmxChannel& channel : mode.channels) {
        for (const int offset : channel.offsets) {
            slots[channel.dmxBreak] = std::max(slots[channel.dmxBreak], offset);
        }
    }
    return slots;
}

std::string firstAttribute(const fixtures::DmxChannel& channel) {
    return channel.logicalChannels.empty() ? "NoFeature" : channel.logicalChannels.front().attribute;
}

Json describeSet(const fixtures::ChannelFunction& function, const fixtures::ChannelSet& set,
                 const fixtures::Wheel* wheel) {
    const int slotCount = wheel == nullptr ? 0 : static_cast<int>(wheel->slots.size());
    const auto physicalAt = [&](std::uint32_t dmx) {
        return fixtures::valueAt(function, dmx, slotCount).physical;
    };
    Json description{{"name", set.name},
                     {"from", set.dmxFrom},
                     {"to", set.dmxTo},
                     {"physical_from", physicalAt(set.dmxFrom)},
                     {"physical_to", physicalAt(set.dmxTo)}};
    if (wheel != nullptr && set.wheelSlotIndex > 0) {
        description["wheel_slot"] = set.wheelSlotIndex;
        description["slot_name"] = wheel->slots[static_cast<std::size_t>(set.wheelSlotIndex - 1)].name;
    }
    return description;
}

Json describeFunction(const fixtures::FixtureType& type, const fixtures::ChannelFunction& function) {
    const fixtures::Wheel* const wheel =
        function.wheelIndex < 0 ? nullptr : &type.wheels[static_cast<std::size_t>(function.wheelIndex)];
    Json sets = Json::array();
    for (const fixtures::ChannelSet& set : function.sets) sets.push_back(describeSet(function, set, wheel));
    Json description{{"name", function.name},
                     {"attribute", function.attribute},
                     {"from", function.dmxFrom},
                     {"to", function.dmxTo},
                     {"physical_from", function.physicalFrom},
                     {"physical_to", function.physicalTo}};
    if (wheel != nullptr) description["wheel"] = wheel->name;
    description["sets"] = std::move(sets);
    return description;
}

Json describeChannel(const fixtures::FixtureType& type, const fixtures::DmxChannel& channel) {
    Json functions = Json::array();
    for (const fixtures::ChannelFunction* function : fixtures::functionsOf(channel)) {
        functions.push_back(describeFunction(type, *function));
    }
    return {{"geometry", channel.geometry},
            {"attribute", firstAttribute(channel)},
            {"break", channel.dmxBreak},
            {"offsets", channel.offsets},
            {"functions", std::move(functions)}};
}

/// Poses of all geometries in the fixture, depth first, before anything moves them.
void appendRestPoses(const fixtures::Geometry& geometry, const glm::dmat4& fixtureFromParent,
                     std::vector<glm::dmat4>& poses) {
    poses.push_back(fixtureFromParent * geometry.parentFromGeometry);
    const glm::dmat4 fixtureFromGeometry = poses.back();
    for (const fixtures::Geometry& child : geometry.children)
        appendRestPoses(child, fixtureFromGeometry, poses);
}

/// The same with attributes at values.
std::vector<glm::dmat4> posesAt(const fixtures::FixtureTypePtr& type, const fixtures::DmxMode& mode,
                                const AttributeValues& values) {
    fixtures::Fixture fixture("inspected", type, mode.name, fixtures::BreakAddresses(), glm::dmat4(1.0));
    for (const auto& [attribute, value] : values) fixture.hold(attribute, value);
    fixture.settle();
    return fixture.state().worldFromNode;
}

/// Where each pose has been taken from the front of `poses`.
void describeBeams(const fixtures::Geometry& geometry, const std::string& parentPath,
                   std::span<const glm::dmat4>& poses, Json& beams) {
    const glm::dmat4& pose = poses.front();
    poses = poses.subspan(1);
    const std::string path = parentPath.empty() ? geometry.name : parentPath + "/" + geometry.name;
    if (geometry.kind == fixtures::GeometryKind::kBeam) {
        beams.push_back({{"path", path},
                         {"position_m", jsonOf(glm::dvec3(pose[3]))},
                         {"direction", jsonOf(-glm::normalize(glm::dvec3(pose[2])))}});
    }
    for (const fixtures::Geometry& child : geometry.children) describeBeams(child, path, poses, beams);
}

Json describeMode(const fixtures::FixtureTypePtr& type, const fixtures::DmxMode& mode,
                  const AttributeValues& values) {
    Json footprint = Json::object();
    for (const auto& [dmxBreak, slots] : footprints(mode)) footprint[std::to_string(dmxBreak)] = slots;
    Json channels = Json::array();
    for (const fixtures::DmxChannel& channel : mode.channels)
        channels.push_back(describeChannel(*type, channel));
    std::vector<glm::dmat4> poses;
    if (values.empty()) {
        appendRestPoses(mode.geometry, glm::dmat4(1.0), poses);
    } else {
        poses = posesAt(type, mode, values);
    }
    Json beams = Json::array();
    std::span<const glm::dmat4> left(poses);
    describeBeams(mode.geometry, "", left, beams);
    return {{"name", mode.name},
            {"footprint", std::move(footprint)},
            {"channels", std::move(channels)},
            {"beams", std::move(beams)}};
}

/// Throws std::runtime_error, which lists what there is, if no mode has one of the attributes.
void requireAttributes(const fixtures::FixtureTypePtr& type, const AttributeValues& values) {
    std::vector<std::string> known;
    for (const fixtures::DmxMode& mode : type->modes) {
        const fixtures::Fixture fixture("inspected", type, mode.name, fixtures::BreakAddresses(),
                                        glm::dmat4(1.0));
        for (const fixtures::AttributeRange& range : fixture.attributes()) known.push_back(range.attribute);
    }
    std::ranges::sort(known);
    known.erase(std::ranges::unique(known).begin(), known.end());
    for (const auto& [attribute, value] : values) {
        if (std::ranges::find(known, attribute) != known.end()) continue;
        throw std::runtime_error(fmt::format("no mode of '{}' has the attribute '{}'.{}", type->name,
                                             attribute, suggestName(attribute, known)));
    }
}

Json describeWheel(const fixtures::Wheel& wheel) {
    Json slots = Json::array();
    for (const fixtures::WheelSlot& slot : wheel.slots) slots.push_back(slot.name);
    return {{"name", wheel.name}, {"slots", std::move(slots)}};
}

Json describeBreaks(const PatchedFixture& patched) {
    Json breaks = Json::array();
    for (const ShowAddress& address : patched.addresses) {
        const protocol::UniverseId universe = address.universes.front();
        breaks.push_back({{"break", address.dmxBreak},
                          {"protocol", protocolName(universe.transport)},
                          {"universe", universe.number},
                          {"slot", address.slot}});
    }
    return breaks;
}

Json describeSlots(const fixtures::Fixture& fixture) {
    Json slots = Json::object();
    for (const fixtures::ChannelPatch& channel : fixture.channels()) {
        if (channel.slots.empty()) continue;
        const bool isTaken = slots.contains(channel.attribute);
        slots[isTaken ? channel.geometry + "." + channel.attribute : channel.attribute] = channel.slots;
    }
    return slots;
}

/// "Port-Address 3, slots 1 to 17; ..."
std::string summarizeAddresses(const PatchedFixture& patched) {
    if (patched.addresses.empty()) return "not patched";
    std::vector<std::string> parts;
    for (const ShowAddress& address : patched.addresses) {
        std::vector<std::string> universes;
        for (const protocol::UniverseId& universe : address.universes)
            universes.push_back(describeUniverse(universe));
        const int footprint = fixtures::footprintOf(patched.fixture.mode(), address.dmxBreak);
        parts.push_back(fmt::format("{}, slots {} to {}", fmt::join(universes, " or "), address.slot,
                                    address.slot + footprint - 1));
    }
    return fmt::format("{}", fmt::join(parts, "; "));
}

double halfAngleDeg(const ShowLight& light) {
    return glm::degrees(0.5 * light.beam.fieldAngleRad);
}

/// Its beam; what a web's file says is not repeated.
std::string summarizeBeam(const ShowLight& light) {
    std::vector<std::string> parts;
    if (light.beam.intensityCd > 0.0) parts.push_back(fmt::format("{} cd", light.beam.intensityCd));
    if (light.beam.fluxLm > 0.0) parts.push_back(fmt::format("{} lm", light.beam.fluxLm));
    parts.push_back(light.webFile.empty() ? fmt::format("half angle {:g} degrees", halfAngleDeg(light))
                                          : fmt::format("web {}", light.webFile.string()));
    return fmt::format("{}", fmt::join(parts, ", "));
}

Json describeLight(const ShowLight& light) {
    Json description{{"name", light.name},
                     {"position_m", jsonOf(light.beam.lensPositionM)},
                     {"direction", jsonOf(-light.beam.worldFromBeam[2])}};
    if (light.beam.intensityCd > 0.0) description["candela"] = light.beam.intensityCd;
    if (light.beam.fluxLm > 0.0) description["lumen"] = light.beam.fluxLm;
    if (light.webFile.empty()) {
        description["half_angle_deg"] = halfAngleDeg(light);
    } else {
        description["web"] = light.webFile.string();
    }
    return description;
}

bool isOnlyNamed(const fixtures::ChannelFunction& function) {
    const fixtures::AttributeKind kind = fixtures::attributeKind(function.attribute);
    return kind == fixtures::AttributeKind::kNamed ||
           (kind == fixtures::AttributeKind::kColorMacro && function.wheelIndex < 0);
}

/// The stretches of a function that has no more to say than their names.
std::string summarizeNames(const fixtures::ChannelFunction& function) {
    std::string text;
    for (const fixtures::ChannelSet& set : function.sets) {
        if (set.name.empty()) continue;
        fmt::format_to(std::back_inserter(text), "                   {}..{}: {}\n", set.dmxFrom, set.dmxTo,
                       set.name);
    }
    return text;
}

}  // namespace

Json describeFixtureType(const fixtures::FixtureTypePtr& type, const AttributeValues& values) {
    if (!values.empty()) requireAttributes(type, values);
    Json modes = Json::array();
    for (const fixtures::DmxMode& mode : type->modes) modes.push_back(describeMode(type, mode, values));
    Json wheels = Json::array();
    for (const fixtures::Wheel& wheel : type->wheels) wheels.push_back(describeWheel(wheel));
    return {{"name", type->name},
            {"manufacturer", type->manufacturer},
            {"modes", std::move(modes)},
            {"wheels", std::move(wheels)},
            {"warnings", type->warnings}};
}

Json describeShow(const Show& show, const Patch& patch) {
    Json fixtures = Json::array();
    auto written = show.fixtures.begin();
    for (const PatchedFixture& patched : patch.fixtures()) {
        fixtures.push_back({{"name", patched.fixture.name()},
                            {"gdtf", written->gdtf},
                            {"mode", patched.fixture.mode().name}});
        if (const auto universe = firstUniverse(patched)) {
            fixtures.back()["protocol"] = protocolName(universe->transport);
            fixtures.back()["universe"] = universe->number;
        }
        if (patched.addresses.size() > 1) fixtures.back()["breaks"] = describeBreaks(patched);
        fixtures.back()["slots"] = describeSlots(patched.fixture);
        ++written;
    }
    Json lights = Json::array();
    for (const ShowLight& light : show.lights) lights.push_back(describeLight(light));
    return {{"fixtures", std::move(fixtures)}, {"lights", std::move(lights)}};
}

std::string summarizeFixtureType(const fixtures::FixtureType& type) {
    std::string text = fmt::format("{} ({})\n", type.name, type.manufacturer);
    const auto out = std::back_inserter(text);
    for (const fixtures::DmxMode& mode : type.modes) {
        fmt::format_to(out, "  mode '{}': {} slots\n", mode.name, mode.footprint);
        for (const fixtures::DmxChannel& channel : mode.channels) {
            fmt::format_to(out, "    {:>11}  {} ({})\n", fmt::format("{}", fmt::join(channel.offsets, ",")),
                           firstAttribute(channel), channel.geometry);
            for (const fixtures::ChannelFunction* function : fixtures::functionsOf(channel)) {
                if (isOnlyNamed(*function)) text += summarizeNames(*function);
            }
        }
    }
    for (const fixtures::Wheel& wheel : type.wheels) {
        fmt::format_to(out, "  wheel '{}': {} slots\n", wheel.name, wheel.slots.size());
    }
    for (const std::string& warning : type.warnings) fmt::format_to(out, "  warning: {}\n", warning);
    return text;
}

std::string summarizeShow(const Show& show, const Patch& patch) {
    std::string text =
        fmt::format("{}: {} fixtures, {} bare lights, {} objects, {} cameras\n", show.title,
                    show.fixtures.size(), show.lights.size(), show.objects.size(), show.cameras.size());
    const auto out = std::back_inserter(text);
    for (const PatchedFixture& patched : patch.fixtures()) {
        const fixtures::Fixture& fixture = patched.fixture;
        fmt::format_to(out, "  {:<20} {}: {}, mode '{}'\n", fixture.name(), summarizeAddresses(patched),
                       fixture.type().name, fixture.mode().name);
    }
    for (const ShowLight& light : show.lights) {
        fmt::format_to(out, "  {:<20} {}\n", light.name, summarizeBeam(light));
    }
    return text;
}

}  // namespace hazer::app
