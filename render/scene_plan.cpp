#include "render/scene_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace hazer::render {
namespace {

constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;

constexpr std::array<std::pair<LightFeatures, const char*>, 7> kFeatureNames{{{kFeatureAir, "AIR"},
                                                                              {kFeatureSurfaces, "SURFACES"},
                                                                              {kFeatureFlat, "FLAT_PROFILE"},
                                                                              {kFeatureGobo, "GOBO"},
                                                                              {kFeatureShadow, "SHADOW"},
                                                                              {kFeatureNoise, "NOISE"},
                                                                              {kFeatureUniform, "UNIFORM"}}};

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

LightFeatures featuresOf(const Beam& beam, const BeamShape& shape, bool hasShadow, LightFeatures common,
                         const Settings& settings) {
    LightFeatures features = common;
    if (shape.exponent == 0.0) features |= kFeatureFlat;
    if (beam.gobo >= 0 && settings.gobos) features |= kFeatureGobo;
    if (hasShadow) features |= kFeatureShadow;
    return features;
}

}  // namespace

std::vector<std::string> featureDefines(LightFeatures features) {
    std::vector<std::string> defines;
    for (const auto& [feature, name] : kFeatureNames) {
        if ((features & feature) != 0) defines.emplace_back(name);
    }
    return defines;
}

std::vector<LightFeatures> allLightVariants() {
    std::vector<LightFeatures> variants;
    for (LightFeatures features = 0; features < (1u << kFeatureNames.size()); ++features) {
        const bool lightsSomething = (features & (kFeatureAir | kFeatureSurfaces)) != 0;
        const bool airOnly = (features & (kFeatureNoise | kFeatureUniform)) != 0;
        if (lightsSomething && (!airOnly || (features & kFeatureAir) != 0)) variants.push_back(features);
    }
    return variants;
}

ScenePlan planScene(const Scene& scene, const Settings& settings,
                    std::span<const BoundingSphere> meshBounds) {
    ScenePlan plan;
    std::vector<int> lit;
    for (std::size_t i = 0; i < scene.beams.size(); ++i) {
        const Beam& beam = scene.beams[i];
        plan.shapes.push_back(beamShape(beam));
        const float brightest = std::max({beam.color.r, beam.color.g, beam.color.b});
        if (plan.shapes.back().peakCd > 0.0 && brightest > 0.0f) lit.push_back(static_cast<int>(i));
    }
    plan.surfaces = !scene.instances.empty();
    plan.air = !lit.empty() && scene.haze.scatteringPerM > 0.0f;
    plan.bloom = settings.bloom;
    for (const int index : lit) {
        const Beam& beam = scene.beams[static_cast<std::size_t>(index)];
        plan.lenses = plan.lenses || (beam.showsLens && beam.lensRadiusM > 0.0);
    }

    std::vector<bool> hasShadow(scene.beams.size(), false);
    if (settings.shadows && (plan.air || plan.surfaces)) {
        plan.shadowMaps = planShadows(scene, lit, plan.shapes, meshBounds);
        for (const ShadowMapPlan& map : plan.shadowMaps) hasShadow[static_cast<std::size_t>(map.beam)] = true;
        // A few lamps get sharp maps; many share the memory.
        if (!plan.shadowMaps.empty()) plan.shadowMapSize = plan.shadowMaps.size() <= 8 ? 1024 : 512;
    }

    LightFeatures common = (plan.air ? kFeatureAir : 0u) | (plan.surfaces ? kFeatureSurfaces : 0u);
    if (plan.air && scene.haze.noise.amount > 0.0f) common |= kFeatureNoise;
    if (plan.air && settings.integrator == Integrator::kUniform) common |= kFeatureUniform;
    std::map<LightFeatures, std::vector<int>> groups;
    for (const int beam : lit) {
        const auto index = static_cast<std::size_t>(beam);
        groups[featuresOf(scene.beams[index], plan.shapes[index], hasShadow[index], common, settings)]
            .push_back(beam);
    }
    for (auto& [features, beams] : groups) plan.groups.push_back({features, std::move(beams)});
    return plan;
}

}  // namespace hazer::render
