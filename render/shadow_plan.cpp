#include "render/shadow_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "render/gpu_beam.h"
#include "render/shadow_detail.h"

namespace hazer::render {
namespace {

/// The rim of the lamp's own body casts nothing.
constexpr double kRimM = 0.01;
/// Half of a cube's face, and a little more, so that a filter at a seam of two faces finds both sides in
/// each.
constexpr double kFaceHalfTangent = 1.05;

/// A body in the world: its bounding sphere, and how low its bounding box reaches.
struct WorldBody {
    glm::dvec3 middleM{0.0};
    double radiusM = 0.0;
    double lowestM = 0.0;  ///< World Z.
};

/// The same as one lamp sees it.
struct Body {
    int instance = 0;
    glm::dvec3 middleM{0.0};  ///< Lamp space.
    double radiusM = 0.0;
    double lowestM = 0.0;
};

/// How much longer a transform makes anything at most.
double largestStretch(const glm::dmat4& m) {
    const double skew =
        std::abs(glm::dot(m[0], m[1])) + std::abs(glm::dot(m[1], m[2])) + std::abs(glm::dot(m[2], m[0]));
    const double squares = glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]);
    // The Frobenius norm bounds a sheared body's, too; without shear the longest edge is exact.
    if (skew > 1e-9 * squares) return std::sqrt(squares);
    return std::max({glm::length(m[0]), glm::length(m[1]), glm::length(m[2])});
}

std::vector<WorldBody> worldBodies(const Scene& scene, std::span<const MeshBounds> bounds) {
    std::vector<WorldBody> bodies;
    bodies.reserve(scene.instances.size());
    for (const MeshInstance& instance : scene.instances) {
        const MeshBounds& mesh = bounds[static_cast<std::size_t>(instance.mesh)];
        const EdgedBox box = edgedBox(mesh.box, instance.worldFromMesh);
        WorldBody body;
        body.middleM = glm::dvec3(instance.worldFromMesh * glm::dvec4(mesh.sphere.centerM, 1.0f));
        body.radiusM = largestStretch(instance.worldFromMesh) * static_cast<double>(mesh.sphere.radiusM);
        body.lowestM = box.middleM.z - std::abs(box.halfEdgesM[0].z) - std::abs(box.halfEdgesM[1].z) -
                       std::abs(box.halfEdgesM[2].z);
        bodies.push_back(body);
    }
    return bodies;
}

/// Can any of it be in the cone? The cone may be wider than a half space.
bool isInCone(const Body& body, const BeamShape& shape) {
    const double along = -body.middleM.z;
    if (shape.cutHalfAngleRad < kWideHalfAngleRad && along + body.radiusM < shape.apexToLensM) return false;
    const double across = std::hypot(body.middleM.x, body.middleM.y);
    const double outside = std::cos(shape.cutHalfAngleRad) * across - std::sin(shape.cutHalfAngleRad) * along;
    return outside <= body.radiusM;
}

/// One lamp and what stands before it.
class Lamp {
 public:
    Lamp(const Scene& scene, int beam, const BeamShape& shape, std::span<const MeshBounds> bounds)
        : scene_(scene),
          shape_(shape),
          bounds_(bounds),
          beam_(beam),
          apexM_(apexPosition(scene.beams[static_cast<std::size_t>(beam)], shape)),
          lampFromWorld_(glm::transpose(scene.beams[static_cast<std::size_t>(beam)].worldFromBeam)) {}

    void look(const std::vector<WorldBody>& world) {
        for (std::size_t i = 0; i < world.size(); ++i) {
            const Body body{static_cast<int>(i), lampFromWorld_ * (world[i].middleM - apexM_),
                            world[i].radiusM, world[i].lowestM};
            if (isInCone(body, shape_)) bodies_.push_back(body);
        }
    }

    std::optional<SurfaceReach> reach() const {
        std::optional<SurfaceReach> reach = isWideLamp(shape_) ? wideReach() : axialReach();
        if (!reach) return reach;
        double lowestM = std::numeric_limits<double>::infinity();
        for (const Body& body : bodies_) lowestM = std::min(lowestM, body.lowestM);
        reach->deepM = apexM_.z - lowestM;
        return reach;
    }

    std::optional<ShadowMapPlan> map() const {
        ShadowMapPlan plan;
        plan.beam = beam_;
        plan.isWide = isWideLamp(shape_);
        for (int face = 0; face < (plan.isWide ? kCubeFaces : 1); ++face) {
            if (std::optional<ShadowFacePlan> found = shadowFace(face))
                plan.faces.push_back(std::move(*found));
        }
        return plan.faces.empty() ? std::nullopt : std::optional(std::move(plan));
    }

 private:
    LampView view() const {
        if (isWideLamp(shape_)) return {kFaceHalfTangent, kRimM};
        return {std::tan(shape_.cutHalfAngleRad), std::max(shape_.apexToLensM, 0.0) + kRimM};
    }

    /// What a face sees of a body, by its box and its sphere.
    std::optional<ViewedPart> viewed(const Body& body, const glm::dmat3& turn, const LampView& view) const {
        const std::optional<ViewedPart> bySphere = viewSphere(turn * body.middleM, body.radiusM, view);
        if (!bySphere) return std::nullopt;
        const MeshInstance& instance = scene_.instances[static_cast<std::size_t>(body.instance)];
        const glm::dmat3 viewFromWorld = turn * lampFromWorld_;
        glm::dmat4 viewFromMesh = glm::dmat4(viewFromWorld * glm::dmat3(instance.worldFromMesh));
        viewFromMesh[3] = glm::dvec4(viewFromWorld * (glm::dvec3(instance.worldFromMesh[3]) - apexM_), 1.0);
        const BoundingBox& box = bounds_[static_cast<std::size_t>(instance.mesh)].box;
        const std::optional<ViewedPart> byBox = viewBox(edgedBox(box, viewFromMesh), view);
        if (!byBox) return std::nullopt;
        std::optional<ViewedPart> part = commonPart(*bySphere, *byBox);
        if (!part || isWideLamp(shape_)) return part;
        const std::optional<TangentRect> cut = cutToCircle(part->rect, view.halfTangent);
        if (!cut) return std::nullopt;
        part->rect = *cut;
        return part;
    }

    std::optional<SurfaceReach> axialReach() const {
        const LampView from = view();
        std::optional<SurfaceReach> reach;
        for (const Body& body : bodies_) {
            // Most bodies change nothing, as their spheres already tell.
            const double middleM = -body.middleM.z;
            if (reach && middleM - body.radiusM >= reach->nearM && middleM + body.radiusM <= reach->farM)
                continue;
            const std::optional<ViewedPart> part = viewed(body, glm::dmat3(1.0), from);
            if (!part) continue;
            // What the rim would cut is lit, from the lens on.
            const double nearM = part->nearM <= from.nearestM ? from.nearestM - kRimM : part->nearM;
            if (!reach) reach = {nearM, part->farM, 0.0};
            reach->nearM = std::min(reach->nearM, nearM);
            reach->farM = std::max(reach->farM, part->farM);
        }
        return reach;
    }

    std::optional<SurfaceReach> wideReach() const {
        std::optional<SurfaceReach> reach;
        for (const Body& body : bodies_) {
            const double farM = glm::length(body.middleM) + body.radiusM;
            reach = {0.0, reach ? std::max(reach->farM, farM) : farM, 0.0};
        }
        return reach;
    }

    std::optional<ShadowFacePlan> shadowFace(int face) const {
        const glm::dmat3 turn = faceFromLamp(face);
        const LampView from = view();
        ShadowFacePlan plan;
        std::optional<ViewedPart> all;
        for (const Body& body : bodies_) {
            if (!scene_.instances[static_cast<std::size_t>(body.instance)].castsShadow) continue;
            const std::optional<ViewedPart> part = viewed(body, turn, from);
            if (!part) continue;
            plan.casters.push_back(body.instance);
            all = all ? enclosingPart(*all, *part) : *part;
        }
        if (!all) return std::nullopt;
        plan.face = face;
        plan.rect = all->rect;
        plan.nearM = all->nearM;
        return plan;
    }

    const Scene& scene_;
    const BeamShape& shape_;
    std::span<const MeshBounds> bounds_;
    int beam_;
    glm::dvec3 apexM_;
    glm::dmat3 lampFromWorld_;
    std::vector<Body> bodies_;
};

}  // namespace

bool isWideLamp(const BeamShape& shape) {
    return shape.cutHalfAngleRad > kWideHalfAngleRad;
}

glm::dmat3 faceFromLamp(int face) {
    // Rows are the face's right, up and backward direction.
    static const std::array<glm::dmat3, kCubeFaces> kFaces{{
        glm::transpose(glm::dmat3({1, 0, 0}, {0, 1, 0}, {0, 0, 1})),
        glm::transpose(glm::dmat3({0, 0, 1}, {0, 1, 0}, {-1, 0, 0})),
        glm::transpose(glm::dmat3({0, 0, -1}, {0, 1, 0}, {1, 0, 0})),
        glm::transpose(glm::dmat3({1, 0, 0}, {0, 0, 1}, {0, -1, 0})),
        glm::transpose(glm::dmat3({1, 0, 0}, {0, 0, -1}, {0, 1, 0})),
        glm::transpose(glm::dmat3({-1, 0, 0}, {0, 1, 0}, {0, 0, -1})),
    }};
    return kFaces[static_cast<std::size_t>(face)];
}

ShadowPlan planShadows(const Scene& scene, const std::vector<int>& lit, const std::vector<BeamShape>& shapes,
                       std::span<const MeshBounds> bounds, const ShadowDetail& detail, bool wantsMaps) {
    const std::vector<WorldBody> bodies = worldBodies(scene, bounds);
    ShadowPlan plan;
    plan.reach.resize(scene.beams.size());
    for (const int beam : lit) {
        const auto index = static_cast<std::size_t>(beam);
        Lamp lamp(scene, beam, shapes[index], bounds);
        lamp.look(bodies);
        plan.reach[index] = lamp.reach();
        if (!wantsMaps || !scene.beams[index].castsShadow || !plan.reach[index]) continue;
        if (std::optional<ShadowMapPlan> map = lamp.map()) plan.maps.push_back(std::move(*map));
    }
    chooseTileSizes(scene, shapes, detail, plan);
    return plan;
}

}  // namespace hazer::render
