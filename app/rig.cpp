#include "app/rig.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <span>

#include "app/beam_optics.h"
#include "app/light_color.h"
#include "app/paint.h"
#include "render/error.h"
#include "render/mesh.h"
#include "render/rig_mesh.h"

namespace hazer::app {
namespace {

/// Beyond this a lens does not focus, and a wider cone does not fit the renderer.
constexpr double kNearestFocusM = 2.0;
constexpr double kFarthestFocusM = 1000.0;
constexpr double kWidestFieldRad = 3.1;
constexpr double kNarrowestFieldRad = 1e-4;

/// Black, where a file has no paint. Bodies cast no shadow: each sits behind its own lens, and hundreds of
/// small casters would cost more than they show.
render::Material bodyMaterial(const std::optional<glm::vec3>& paint) {
    render::Material material = materialOf(paint, render::Color(0.03f));
    material.shininess = 20.0f;
    return material;
}

/// Wash, PC and Fresnel lamps have soft edges, also where a file gives them but one angle: that is taken as
/// the angle of 10 %.
double beamOverField(fixtures::BeamType type) {
    switch (type) {
        case fixtures::BeamType::kWash:
            return 0.6;
        case fixtures::BeamType::kFresnel:
            return 0.65;
        case fixtures::BeamType::kPc:
            return 0.8;
        default:
            return 1.0;
    }
}

/// What only glows sends as much light everywhere as it shows area (Lambert): 50 % at 60 degrees.
constexpr double kGlowBeamDeg = 120.0;
constexpr double kGlowFieldDeg = 168.0;

void setAngles(const fixtures::BeamState& state, render::Beam& beam) {
    const bool glows = state.type == fixtures::BeamType::kGlow;
    const double fieldRad = glm::radians(glows ? kGlowFieldDeg : state.fieldAngleDeg);
    const double beamRad = glm::radians(glows ? kGlowBeamDeg : state.beamAngleDeg);
    beam.fieldAngleRad = std::clamp(fieldRad, kNarrowestFieldRad, kWidestFieldRad);
    beam.beamAngleRad = std::clamp(beamRad, kNarrowestFieldRad, beam.fieldAngleRad);
    if (beam.beamAngleRad == beam.fieldAngleRad) beam.beamAngleRad *= beamOverField(state.type);
    beam.edge = beam.beamAngleRad < beam.fieldAngleRad ? render::BeamEdge::kSoft : render::BeamEdge::kFlat;
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

/// Hundreds of fixtures have the same body.
constexpr std::size_t kMostBodyVertices = 100'000;
constexpr std::size_t kMostVerticesOfBodies = 1'500'000;

/// Scales each axis about the origin so that the bounds have edges of 1: a GDTF model's own units mean
/// nothing (DIN SPEC 15800, Models).
void fitToUnit(std::vector<render::PaintedMesh>& meshes) {
    glm::vec3 low(meshes.front().mesh.vertices.front().positionM);
    glm::vec3 high = low;
    for (const render::PaintedMesh& painted : meshes) {
        const render::BoundingBox box = render::boundingBox(painted.mesh);
        low = glm::min(low, box.lowM);
        high = glm::max(high, box.highM);
    }
    const glm::vec3 size = high - low;
    // What is flat has no size to go by along that axis.
    const float largest = std::max({size.x, size.y, size.z, 1e-6f});
    glm::vec3 perSize;
    for (int axis = 0; axis < 3; ++axis)
        perSize[axis] = 1.0f / (size[axis] > 1e-6f * largest ? size[axis] : largest);
    for (render::PaintedMesh& painted : meshes) {
        for (render::Vertex& vertex : painted.mesh.vertices) {
            vertex.positionM *= perSize;
            vertex.normal = glm::normalize(vertex.normal / perSize);
        }
    }
}

std::size_t vertexCount(const std::vector<render::PaintedMesh>& meshes) {
    std::size_t count = 0;
    for (const render::PaintedMesh& painted : meshes) count += painted.mesh.vertices.size();
    return count;
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
    setAngles(state, beam);
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
        appendCopies(lamp, *beam, scene.beams);
    }
    for (const fixtures::PartState& part : state.parts) {
        if (part.model != nullptr) appendPart(part, scene);
    }
}

void Rig::appendPart(const fixtures::PartState& part, render::Scene& scene) {
    const glm::dmat4 worldFromUnit = glm::scale(part.worldFromPart, part.model->sizeM);
    render::MeshInstance instance;
    instance.castsShadow = false;
    instance.worldFromMesh = worldFromUnit;
    const std::vector<BodyPart>& body = partsOf(part.model->file);
    for (const BodyPart& painted : body) {
        instance.mesh = painted.mesh;
        instance.material = painted.material;
        scene.instances.push_back(instance);
    }
    if (!body.empty()) return;
    instance.material = bodyMaterial({});
    instance.mesh = meshFor(part.model->primitive);
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

const std::vector<Rig::BodyPart>& Rig::partsOf(const std::shared_ptr<const fixtures::ModelFile>& file) {
    const auto [entry, isNew] = bodies_.try_emplace(file);
    if (!isNew || file == nullptr) return entry->second;
    try {
        entry->second = readBody(*file);
    } catch (const render::RenderError& error) {
        spdlog::warn("a fixture's body is drawn as a plain shape: {}", error.what());
    }
    return entry->second;
}

std::vector<Rig::BodyPart> Rig::readBody(const fixtures::ModelFile& file) {
    std::vector<render::PaintedMesh> meshes;
    // What is refused has taken its time, too, and is counted.
    if (bodyVertices_ < kMostVerticesOfBodies) meshes = render::parseRigMesh(file.bytes, file.name);
    const std::size_t vertices = vertexCount(meshes);
    bodyVertices_ += vertices;
    if (vertices > kMostBodyVertices || bodyVertices_ >= kMostVerticesOfBodies) {
        throw render::RenderError(fmt::format("{} has more than {} vertices, or all bodies more than {}",
                                              file.name, kMostBodyVertices, kMostVerticesOfBodies));
    }
    fitToUnit(meshes);
    std::vector<BodyPart> parts;
    for (const render::PaintedMesh& painted : meshes)
        parts.push_back({assets_.addMesh(painted.mesh), bodyMaterial(painted.paint)});
    return parts;
}

render::MeshId Rig::meshFor(fixtures::PrimitiveType primitive) {
    const auto known = meshes_.find(primitive);
    if (known != meshes_.end()) return known->second;
    const render::MeshId id = assets_.addMesh(shapeOf(primitive));
    meshes_.emplace(primitive, id);
    return id;
}

}  // namespace hazer::app
