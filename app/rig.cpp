#include "app/rig.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <span>

#include "app/beam_optics.h"
#include "app/light_color.h"
#include "render/mesh.h"

namespace hazer::app {
namespace {

/// Beyond this a lens does not focus, and a wider cone does not fit the renderer.
constexpr double kNearestFocusM = 2.0;
constexpr double kFarthestFocusM = 1000.0;
constexpr double kWidestFieldRad = 3.1;
constexpr double kNarrowestFieldRad = 1e-4;

/// Black paint. Bodies cast no shadow: each sits behind its own lens, and hundreds of small casters would
/// cost more than they show.
render::Material bodyMaterial() {
    render::Material material;
    material.albedo = render::Color(0.03f);
    material.shininess = 20.0f;
    return material;
}

render::BeamEdge edgeOf(double beamAngleRad, double fieldAngleRad) {
    return beamAngleRad < fieldAngleRad ? render::BeamEdge::kSoft : render::BeamEdge::kFlat;
}

render::Mesh shapeOf(fixtures::PrimitiveType primitive) {
    switch (primitive) {
        case fixtures::PrimitiveType::kCylinder:
            return render::makeCylinder();
        case fixtures::PrimitiveType::kSphere:
            return render::makeSphere();
        default:
            return render::makeBox();
    }
}

/// A box in the coordinates of a part whose edges are 1.
struct UnitBox {
    glm::dvec3 center;
    glm::dvec3 size;
};

/// A crossbar above and an arm on each side, open below for the head.
constexpr std::array kYokeBoxes{UnitBox{{0.0, 0.0, 0.45}, {1.0, 1.0, 0.1}},
                                UnitBox{{-0.45, 0.0, -0.05}, {0.1, 1.0, 0.9}},
                                UnitBox{{0.45, 0.0, -0.05}, {0.1, 1.0, 0.9}}};
constexpr std::array kWholeBox{UnitBox{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}}};

/// What a part is put together from: one shape, but for a yoke, which as one box would hide the head inside
/// it.
std::span<const UnitBox> boxesOf(fixtures::PrimitiveType primitive) {
    if (primitive == fixtures::PrimitiveType::kYoke) return kYokeBoxes;
    return kWholeBox;
}

}  // namespace

double focusDistanceM(double focus) {
    const double dioptres = (1.0 - std::clamp(focus, 0.0, 1.0)) / kNearestFocusM;
    return dioptres * kFarthestFocusM > 1.0 ? 1.0 / dioptres : kFarthestFocusM;
}

std::optional<render::Beam> beamFromState(const fixtures::BeamState& state) {
    const double fluxLm = state.fluxLm * state.colorXyz.y;
    if (state.type == fixtures::BeamType::kNone || !(fluxLm > 0.0)) return std::nullopt;
    render::Beam beam;
    beam.lensPositionM = glm::dvec3(state.worldFromBeam[3]);
    beam.worldFromBeam = glm::dmat3(state.worldFromBeam);
    beam.lensRadiusM = state.lensRadiusM;
    beam.fieldAngleRad = std::clamp(glm::radians(state.fieldAngleDeg), kNarrowestFieldRad, kWidestFieldRad);
    beam.beamAngleRad = std::clamp(glm::radians(state.beamAngleDeg), kNarrowestFieldRad, beam.fieldAngleRad);
    beam.edge = edgeOf(beam.beamAngleRad, beam.fieldAngleRad);
    beam.fluxLm = fluxLm;
    beam.color = lightColorFromXyz(state.colorXyz);
    if (state.focusDistanceM) {
        beam.focusDistanceM = std::clamp(*state.focusDistanceM, 0.0, kFarthestFocusM);
    } else if (state.focus) {
        beam.focusDistanceM = focusDistanceM(*state.focus);
    }
    return beam;
}

Rig::Rig(render::AssetSink& assets) : assets_(assets) {}

void Rig::append(const fixtures::FixtureState& state, render::Scene& scene) {
    for (const fixtures::BeamState& lamp : state.beams) {
        std::optional<render::Beam> beam = beamFromState(lamp);
        if (!beam) continue;
        applyOptics(
            lamp, [this](const auto& image) { return goboFor(image); }, *beam);
        for (const render::Beam& copy : throughPrisms(lamp, *beam)) scene.beams.push_back(copy);
    }
    for (const fixtures::PartState& part : state.parts) {
        if (part.model != nullptr) appendPart(part, scene);
    }
}

void Rig::appendPart(const fixtures::PartState& part, render::Scene& scene) {
    const glm::dmat4 worldFromUnit = glm::scale(part.worldFromPart, part.model->sizeM);
    render::MeshInstance instance;
    instance.mesh = meshFor(part.model->primitive);
    instance.material = bodyMaterial();
    instance.castsShadow = false;
    for (const UnitBox& box : boxesOf(part.model->primitive)) {
        instance.worldFromMesh = glm::scale(glm::translate(worldFromUnit, box.center), box.size);
        scene.instances.push_back(instance);
    }
}

render::GoboId Rig::goboFor(const std::shared_ptr<const fixtures::WheelImage>& image) {
    const auto known = gobos_.find(image);
    if (known != gobos_.end()) return known->second;
    const render::GoboId id = assets_.addGobo(image->rgba.data(), image->width, image->height);
    gobos_.emplace(image, id);
    return id;
}

render::MeshId Rig::meshFor(fixtures::PrimitiveType primitive) {
    const auto known = meshes_.find(primitive);
    if (known != meshes_.end()) return known->second;
    const render::MeshId id = assets_.addMesh(shapeOf(primitive));
    meshes_.emplace(primitive, id);
    return id;
}

}  // namespace hazer::app
