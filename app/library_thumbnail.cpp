#include "app/library_thumbnail.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

#include "app/light_color.h"
#include "app/picture_file.h"
#include "app/session.h"

namespace hazer::app {
namespace {

using fixtures::AttributeKind;

/// Red, green and blue of the looks, and their hue.
struct ColorLook {
    std::array<double, 3> rgb;
    double hueDeg;
};
constexpr std::array kLooks{ColorLook{{0.1, 0.45, 1.0}, 215.0}, ColorLook{{1.0, 0.5, 0.1}, 30.0},
                            ColorLook{{0.9, 0.1, 0.6}, 320.0}, ColorLook{{0.1, 0.9, 0.5}, 155.0}};

constexpr double kHangHeightM = 2.0;
constexpr double kZoomDeg = 16.0;
constexpr double kPanDeg = -90.0;
constexpr double kTiltDeg = 16.0;

/// How bright the picture's light parts come out, and the black paint of the bodies beside them.
constexpr double kLightShare = 0.9;
constexpr double kBodyShare = 0.15;
constexpr double kBodyAlbedo = 0.03;
constexpr double kSaturationPerEv = 1.2;  // cd/m^2 of white at EV100 0 (ISO 2721)

double inRange(const fixtures::AttributeRange& range, double value) {
    const auto [low, high] = std::minmax(range.physicalFrom, range.physicalTo);
    return std::clamp(value, low, high);
}

/// What an attribute stands at in the picture. Empty: where it rests.
std::optional<double> posed(const fixtures::AttributeRange& range, const fixtures::Fixture& fixture,
                            const ColorLook& look) {
    const fixtures::Attribute attribute = fixtures::attributeOf(range.attribute);
    const auto color = static_cast<std::size_t>(attribute.number);
    const auto has = [&fixture](std::string_view name) { return fixture.value(name).has_value(); };
    switch (attribute.kind) {
        case AttributeKind::kDimmer:
        case AttributeKind::kBrightness:
        case AttributeKind::kFog:
        case AttributeKind::kHaze:
        case AttributeKind::kFan:
        case AttributeKind::kBeamShaper:
            return range.physicalTo;
        case AttributeKind::kPan:
            return inRange(range, kPanDeg);
        case AttributeKind::kTilt:
            return inRange(range, kTiltDeg);
        case AttributeKind::kZoom:
            return inRange(range, kZoomDeg);
        case AttributeKind::kGoboWheel:
            // Of two wheels the second is the one whose gobos turn.
            return attribute.number == 2 || !has("Gobo2") ? 3.0 : 1.0;
        case AttributeKind::kBladeA:
            return !has("Gobo1") && attribute.number <= 2 ? std::optional(0.3) : std::nullopt;
        case AttributeKind::kColorAdd:
        case AttributeKind::kColorRgb:
            return color < 3 ? look.rgb[color] : 0.1;
        case AttributeKind::kColorSub:
            // Cyan, magenta and yellow come fourth to sixth and take out red, green and blue.
            return color >= 3 && color < 6 ? std::optional(1.0 - look.rgb[color - 3]) : std::nullopt;
        case AttributeKind::kHue:
            return look.hueDeg;
        case AttributeKind::kSaturation:
            return 0.8;
        default:
            return std::nullopt;
    }
}

bool standsOnTheFloor(const fixtures::FixtureState& state) {
    return state.beams.empty() || state.beams.front().worldFromBeam[2].z < 0.0;
}

Show thumbnailShow(const LibraryEntry& entry, const ColorLook& look) {
    const std::string& mode = entry.type->modes.front().name;
    const fixtures::Fixture fixture("lamp", entry.type, mode, 1, glm::dmat4(1.0));
    ShowFixture patched;
    patched.name = "lamp";
    patched.gdtf = entry.folder;
    patched.mode = mode;
    for (const fixtures::AttributeRange& range : fixture.attributes()) {
        if (const auto value = posed(range, fixture, look)) patched.held[range.attribute] = *value;
    }
    const bool stands = standsOnTheFloor(fixture.state());
    patched.positionM.z = stands ? 0.0 : kHangHeightM;

    Show show;
    show.file = "thumbnail.toml";
    show.haze.extinctionPerM = show.haze.scatteringPerM = 0.08f;
    ShowCamera camera{"thumbnail", {}};
    camera.camera = {.positionM = {0.15, -2.9, 1.5}, .targetM = {0.15, 0.0, 0.98}, .verticalFovRad = 0.75};
    show.cameras.push_back(camera);
    show.fixtures.push_back(patched);
    ShowObject floor;
    floor.shape = ObjectShape::kFloor;
    floor.name = "floor";
    floor.sizeM = {30.0, 30.0, 0.0};
    floor.material.albedo = render::Color(0.05f);
    floor.material.specular = 0.0f;
    show.objects.push_back(floor);
    return show;
}

/// What nearly all of the picture stays below [cd/m^2].
double brightLuminance(const render::FloatImage& radiance) {
    std::vector<double> luminances;
    for (std::size_t i = 0; i + 2 < radiance.rgb.size(); i += 3) {
        luminances.push_back(luminance({radiance.rgb[i], radiance.rgb[i + 1], radiance.rgb[i + 2]}));
    }
    const auto place = luminances.begin() + static_cast<std::ptrdiff_t>(luminances.size() * 985 / 1000);
    std::nth_element(luminances.begin(), place, luminances.end());
    return std::max(*place, 1e-3);
}

/// Light from beside the camera that shows the body, and hardly anything of the air.
render::Beam bodyLight(const render::Camera& camera, const glm::dvec3& bodyM, double whiteCdPerM2) {
    render::Beam beam;
    beam.lensPositionM = camera.positionM + glm::dvec3(-1.2, 0.8, 0.8);
    const glm::dvec3 way = bodyM - beam.lensPositionM;
    beam.worldFromBeam =
        glm::dmat3(glm::mat3_cast(glm::dquat(glm::dvec3(0.0, 0.0, -1.0), glm::normalize(way))));
    beam.lensRadiusM = 0.0;
    beam.showsLens = false;
    beam.fieldAngleRad = 0.4;
    beam.beamAngleRad = 0.3;
    const double bodyLx = kBodyShare * whiteCdPerM2 * std::numbers::pi / kBodyAlbedo;
    beam.intensityCd = bodyLx * glm::dot(way, way);
    return beam;
}

}  // namespace

void drawThumbnail(const LibraryEntry& entry, int number, int width, int height,
                   const std::filesystem::path& file) {
    const ColorLook& look = kLooks[static_cast<std::size_t>(number) % kLooks.size()];
    Session session(thumbnailShow(entry, look), {});
    session.settle();
    session.settings().width = width;
    session.settings().height = height;
    render::Scene scene = session.scene();
    // The floor is nearer than lenses focus.
    for (render::Beam& beam : scene.beams) beam.focusDistanceM = 0.0;
    const glm::dvec3 bodyM = session.show().fixtures.front().positionM + glm::dvec3(0.0, 0.0, -0.3);
    session.renderer().render(scene, session.camera(), session.settings());
    const double whiteCdPerM2 = brightLuminance(session.renderer().readRadiance()) / kLightShare;
    scene.beams.push_back(bodyLight(session.camera(), bodyM, whiteCdPerM2));
    session.settings().exposureEv100 = static_cast<float>(std::log2(whiteCdPerM2 / kSaturationPerEv));
    session.renderer().render(scene, session.camera(), session.settings());
    writePicture(session.renderer(), file);
}

}  // namespace hazer::app
