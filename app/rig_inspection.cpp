#include "app/rig_inspection.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "fixtures/text.h"

namespace hazer::app {
namespace {

using Json = nlohmann::ordered_json;
using fixtures::MvrKind;
using fixtures::MvrObject;
using fixtures::MvrScene;

Json jsonOfPoint(const glm::dvec3& vector) {
    return {vector.x, vector.y, vector.z};
}

/// Down, where the axes are too flat to tell.
glm::dvec3 directionOf(const glm::dmat4& worldFromFixture) {
    const glm::dvec3 z(worldFromFixture[2]);
    return glm::length(z) > 0.0 ? -glm::normalize(z) : glm::dvec3(0.0, 0.0, -1.0);
}

Json describeFixture(const MvrObject& object) {
    Json addresses = Json::array();
    for (const fixtures::MvrAddress& address : object.device->addresses) {
        addresses.push_back(
            {{"break", address.dmxBreak}, {"universe", address.universe}, {"slot", address.slot}});
    }
    return {{"name", object.name},
            {"gdtf", object.device->gdtfSpec},
            {"mode", object.device->gdtfMode},
            {"addresses", std::move(addresses)},
            {"position_m", jsonOfPoint(glm::dvec3(object.worldFromObject[3]))},
            {"direction", jsonOfPoint(directionOf(object.worldFromObject))}};
}

bool isFixture(const MvrObject& object) {
    return object.kind == MvrKind::kFixture;
}

int countObjects(const MvrScene& scene) {
    int count = 0;
    for (const MvrObject& object : scene.objects) {
        if (!isFixture(object) && object.kind != MvrKind::kGroup) ++count;
    }
    return count;
}

std::string addressText(const fixtures::MvrDevice& device) {
    if (device.addresses.empty()) return "not patched";
    std::vector<std::string> parts;
    for (const fixtures::MvrAddress& address : device.addresses)
        parts.push_back(fmt::format("{}.{}", address.universe, address.slot));
    return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

Json describeRig(const MvrScene& scene, const std::vector<std::string>& warnings) {
    Json fixtures = Json::array();
    for (const MvrObject& object : scene.objects) {
        if (isFixture(object)) fixtures.push_back(describeFixture(object));
    }
    return {{"fixtures", std::move(fixtures)}, {"objects", countObjects(scene)}, {"warnings", warnings}};
}

std::string summarizeRig(const MvrScene& scene, const std::vector<std::string>& warnings) {
    std::string lines;
    const auto out = std::back_inserter(lines);
    int fixtures = 0;
    for (const MvrObject& object : scene.objects) {
        if (!isFixture(object)) continue;
        ++fixtures;
        const glm::dvec3 position(object.worldFromObject[3]);
        fmt::format_to(out, "  {:<26} {:<14} at ({:.2f}, {:.2f}, {:.2f}) m: {}, mode {}\n",
                       fixtures::inQuotes(object.name), addressText(*object.device), position.x, position.y,
                       position.z, fixtures::inQuotes(object.device->gdtfSpec),
                       fixtures::inQuotes(object.device->gdtfMode));
    }
    for (const std::string& warning : warnings) fmt::format_to(out, "  warning: {}\n", warning);
    return fmt::format("MVR {}.{} by {}: {} fixtures, {} objects, {} layers\n{}", scene.versionMajor,
                       scene.versionMinor, fixtures::inQuotes(scene.provider), fixtures, countObjects(scene),
                       scene.layers.size(), lines);
}

}  // namespace hazer::app
