#include "app/show_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/light_color.h"
#include "app/show_limits.h"

namespace hazer::app {
namespace {

constexpr Limits kIntensity{1e-3, 1e9};     // cd, lm
constexpr Limits kHalfAngle{0.005, 179.0};  // deg
constexpr Limits kLensRadius{0.0, 10.0};    // m
constexpr Limits kFocus{0.0, 1e5};          // m

enum class Profile : std::uint8_t { kFlat, kSoft, kWeb };

// In the order of Profile.
const std::vector<std::string> kProfiles{"flat", "soft", "web"};

/// Without the length's own unit under way, so that neither the largest nor the smallest numbers overflow.
glm::dvec3 unitOf(const glm::dvec3& v) {
    return glm::normalize(v / std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}));
}

glm::dvec3 readDirection(TomlReader& reader, const glm::dvec3& positionM) {
    if (reader.requiredOneOf("direction", "target") == "target") {
        const glm::dvec3 targetM = reader.requiredVector("target", kLength);
        if (glm::distance(positionM, targetM) < 1e-6) {
            reader.fail("the light stands where its 'target' is; move one of them");
        }
        return unitOf(targetM - positionM);
    }
    const glm::dvec3 direction = reader.requiredVector("direction", kLength);
    if (direction == glm::dvec3(0.0)) reader.fail("'direction' in [[light]] must not be [0, 0, 0]");
    return unitOf(direction);
}

/// What is up in the light's picture; world Z, or Y for a light that shines straight up or down.
glm::dvec3 readUp(TomlReader& reader, const glm::dvec3& direction) {
    constexpr double kParallel = 1e-6;
    const auto isParallel = [&](const glm::dvec3& v) {
        return glm::length(glm::cross(v, direction)) < kParallel;
    };
    const glm::dvec3 zAxis(0.0, 0.0, 1.0);
    const glm::dvec3 otherwise = isParallel(zAxis) ? glm::dvec3(0.0, 1.0, 0.0) : zAxis;
    const glm::dvec3 up = reader.vector("up", otherwise, kLength);
    if (up == glm::dvec3(0.0)) reader.fail("'up' in [[light]] must not be [0, 0, 0]");
    if (isParallel(unitOf(up))) {
        reader.fail("'up' in [[light]] must not lie along the light's direction; leave it out or turn it");
    }
    return unitOf(up);
}

void readPose(TomlReader& reader, render::Beam& beam) {
    beam.lensPositionM = reader.requiredVector("position", kLength);
    const glm::dvec3 direction = readDirection(reader, beam.lensPositionM);
    const glm::dvec3 right = glm::normalize(glm::cross(direction, readUp(reader, direction)));
    beam.worldFromBeam = glm::dmat3(right, glm::cross(right, direction), -direction);
}

/// A web brings its own intensity, which the show may replace; other beams need one.
void readIntensity(TomlReader& reader, Profile profile, render::Beam& beam) {
    std::optional<std::string_view> key = reader.oneOf("candela", "lumen");
    if (!key && profile != Profile::kWeb) key = reader.requiredOneOf("candela", "lumen");
    if (key == "candela") beam.intensityCd = reader.requiredNumber("candela", kIntensity);
    if (key == "lumen") beam.fluxLm = reader.requiredNumber("lumen", kIntensity);
}

void readAngles(TomlReader& reader, Profile profile, render::Beam& beam) {
    const double halfAngleDeg = reader.requiredNumber("half_angle", kHalfAngle);
    double beamHalfAngleDeg = halfAngleDeg;
    if (profile == Profile::kSoft) {
        beamHalfAngleDeg = reader.requiredNumber("beam_half_angle", {kHalfAngle.lowest, halfAngleDeg});
    } else if (reader.has("beam_half_angle")) {
        reader.fail("'beam_half_angle' in [[light]] needs profile = \"soft\"; a flat beam has one angle");
    }
    beam.edge = profile == Profile::kSoft ? render::BeamEdge::kSoft : render::BeamEdge::kFlat;
    beam.fieldAngleRad = glm::radians(2.0 * halfAngleDeg);
    beam.beamAngleRad = glm::radians(2.0 * beamHalfAngleDeg);
}

/// The file of a beam that has been measured; empty for one that is described.
std::filesystem::path readProfile(TomlReader& reader, render::Beam& beam,
                                  const std::filesystem::path& folder) {
    const auto profile = static_cast<Profile>(reader.choice("profile", kProfiles, 0));
    readIntensity(reader, profile, beam);
    if (profile != Profile::kWeb) {
        readAngles(reader, profile, beam);
        if (reader.has("web")) reader.fail("'web' in [[light]] needs profile = \"web\"");
        return {};
    }
    for (const char* key : {"half_angle", "beam_half_angle"}) {
        if (reader.has(key)) {
            reader.fail(fmt::format("'{}' in [[light]] is what the 'web' says; leave it out", key));
        }
    }
    return folder / reader.requiredText("web");
}

/// The colour with luminance 1, so that candela stay candela.
render::Color readLightColor(TomlReader& reader) {
    const glm::dvec3 rec709 = reader.vector("color", glm::dvec3(1.0), kColor);
    if (rec709 == glm::dvec3(0.0)) {
        reader.fail("'color' in [[light]] must not be [0, 0, 0]; a dark light is left out of the show");
    }
    const double largest = std::max({rec709.r, rec709.g, rec709.b});
    const glm::dvec3 color(rec2020FromRec709(rec709 / largest));
    return render::Color(color / luminance(color));
}

std::filesystem::path readGobo(TomlReader& reader, render::Beam& beam, const std::filesystem::path& folder) {
    if (!reader.has("gobo")) {
        for (const char* key : {"gobo_rotation", "focus"}) {
            if (reader.has(key)) reader.fail(fmt::format("'{}' in [[light]] needs a 'gobo'", key));
        }
        return {};
    }
    if (beam.fieldAngleRad > 2.0 * kWidestGoboRad) {
        reader.fail(fmt::format("a light with a 'gobo' needs a 'half_angle' of at most {}",
                                glm::degrees(kWidestGoboRad)));
    }
    beam.goboRotationRad = glm::radians(reader.number("gobo_rotation", 0.0, kAngle));
    beam.focusDistanceM = reader.number("focus", 0.0, kFocus);
    return folder / reader.requiredText("gobo");
}

}  // namespace

ShowLight readLight(TomlReader& reader, const std::filesystem::path& folder) {
    ShowLight light;
    light.line = reader.line();
    light.name = reader.requiredText("name");
    readPose(reader, light.beam);
    light.webFile = readProfile(reader, light.beam, folder);
    light.beam.lensRadiusM = reader.number("lens_radius", 0.0, kLensRadius);
    light.beam.showsLens = false;
    light.beam.color = readLightColor(reader);
    light.goboFile = readGobo(reader, light.beam, folder);
    light.beam.castsShadow = reader.flag("shadow", true);
    reader.refuseUnknownKeys();
    return light;
}

}  // namespace hazer::app
