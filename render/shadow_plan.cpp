#include "render/shadow_plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hazer::render {
namespace {

constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;

struct WorldSphere {
    glm::dvec3 centerM;
    double radiusM;
};

WorldSphere worldSphere(const MeshInstance& instance, const BoundingSphere& bounds) {
    const glm::dmat4& m = instance.worldFromMesh;
    const double scale = std::max(
        {glm::length(glm::dvec3(m[0])), glm::length(glm::dvec3(m[1])), glm::length(glm::dvec3(m[2]))});
    return {glm::dvec3(m * glm::dvec4(bounds.centerM, 1.0f)), scale * static_cast<double>(bounds.radiusM)};
}

/// Cone against sphere; the sphere's reach along the axis comes back in `farM`.
bool sphereInCone(const WorldSphere& sphere, const Beam& beam, const BeamShape& shape, double& farM) {
    const glm::dvec3 fromApex = sphere.centerM - apexPosition(beam, shape);
    const double along = -glm::dot(fromApex, beam.worldFromBeam[2]);
    farM = along + sphere.radiusM;
    if (farM < shape.apexToLensM) return false;
    const double across = std::sqrt(std::max(glm::dot(fromApex, fromApex) - along * along, 0.0));
    const double outside = std::cos(shape.cutHalfAngleRad) * across - std::sin(shape.cutHalfAngleRad) * along;
    return outside <= sphere.radiusM;
}

ShadowMapPlan planShadow(const Scene& scene, int beamIndex, const BeamShape& shape,
                         const std::vector<WorldSphere>& spheres) {
    // A single projection cannot look further around than this; what lies outside is lit.
    constexpr double kWidestRad = 80.0 * kRadPerDeg;
    const Beam& beam = scene.beams[static_cast<std::size_t>(beamIndex)];
    ShadowMapPlan plan;
    plan.beam = beamIndex;
    // A centimetre past the lens: the rim of the lamp's own body casts nothing.
    plan.projection = {std::min(shape.cutHalfAngleRad, kWidestRad), shape.apexToLensM + 0.01, 0.0};
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        double farM = 0.0;
        if (!scene.instances[i].castsShadow || !sphereInCone(spheres[i], beam, shape, farM)) continue;
        plan.casters.push_back(static_cast<int>(i));
        plan.projection.farM = std::max(plan.projection.farM, farM);
    }
    plan.projection.farM = std::max(plan.projection.farM, plan.projection.nearM * 1.01 + 0.01);
    return plan;
}

}  // namespace

std::vector<ShadowMapPlan> planShadows(const Scene& scene, const std::vector<int>& lit,
                                       const std::vector<BeamShape>& shapes,
                                       std::span<const BoundingSphere> meshBounds) {
    std::vector<WorldSphere> spheres;
    spheres.reserve(scene.instances.size());
    for (const MeshInstance& instance : scene.instances) {
        spheres.push_back(worldSphere(instance, meshBounds[static_cast<std::size_t>(instance.mesh)]));
    }
    std::vector<ShadowMapPlan> maps;
    for (const int beam : lit) {
        const auto index = static_cast<std::size_t>(beam);
        if (!scene.beams[index].castsShadow) continue;
        ShadowMapPlan map = planShadow(scene, beam, shapes[index], spheres);
        if (!map.casters.empty()) maps.push_back(std::move(map));
    }
    if (maps.size() > static_cast<std::size_t>(kMaxShadowMaps)) {
        const auto brighter = [&](const ShadowMapPlan& a, const ShadowMapPlan& b) {
            return scene.beams[static_cast<std::size_t>(a.beam)].fluxLm >
                   scene.beams[static_cast<std::size_t>(b.beam)].fluxLm;
        };
        std::stable_sort(maps.begin(), maps.end(), brighter);
        maps.resize(static_cast<std::size_t>(kMaxShadowMaps));
    }
    return maps;
}

}  // namespace hazer::render
