#include "render/scene_plan.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "render/air_quality.h"
#include "render/beam_width.h"
#include "render/camera.h"
#include "render/delta_eddington.h"
#include "render/profile_rule.h"
#include "render/shadow_atlas.h"

namespace hazer::render {
namespace {

constexpr std::array<std::pair<LightFeatures, const char*>, 11> kFeatureNames{
    {{kFeatureFlat, "FLAT_PROFILE"},
     {kFeatureGobo, "GOBO"},
     {kFeatureShadow, "SHADOW"},
     {kFeatureNoise, "NOISE"},
     {kFeatureUniform, "UNIFORM"},
     {kFeatureWeb, "WEB"},
     {kFeatureCount, "COUNT"},
     {kFeatureWide, "SHADOW_FACES"},
     {kFeatureSampled, "SAMPLED"},
     {kFeatureBackwards, "BACKWARDS"},
     {kFeatureLine, "LINE"}}};

/// What only the light in the air knows.
constexpr LightFeatures kAirOnly =
    kFeatureNoise | kFeatureUniform | kFeatureCount | kFeatureSampled | kFeatureBackwards | kFeatureLine;

bool canBe(LightFeatures features) {
    const auto together = [features](LightFeatures two) { return (features & two) == two; };
    const auto either = [features](LightFeatures some) { return (features & some) != 0; };
    const bool isWideWithoutShadow = (features & kFeatureWide) != 0 && (features & kFeatureShadow) == 0;
    const bool isBackwardsInVain =
        either(kFeatureBackwards) && (either(kFeatureWeb | kFeatureGobo | kFeatureUniform) ||
                                      (features & (kFeatureShadow | kFeatureWide)) == kFeatureShadow);
    const bool isLineInVain =
        either(kFeatureLine) && either(kFeatureWeb | kFeatureUniform | kFeatureWide | kFeatureBackwards);
    return !together(kFeatureFlat | kFeatureWeb) && !together(kFeatureUniform | kFeatureSampled) &&
           !isWideWithoutShadow && !isBackwardsInVain && !isLineInVain;
}

/// Every combination of features without those of `never`.
std::vector<LightFeatures> variantsWithout(LightFeatures never) {
    std::vector<LightFeatures> variants;
    for (LightFeatures features = 0; features < (1u << kFeatureNames.size()); ++features) {
        if ((features & never) == 0 && canBe(features)) variants.push_back(features);
    }
    return variants;
}

BeamShape shapeOf(const Beam& beam, std::span<const IesWeb> webs, bool isComposed) {
    if (beam.web < 0) return beamShape(beam, isComposed);
    const auto web = static_cast<std::size_t>(beam.web);
    assert(web < webs.size());
    return webShape(beam, webs[web]);
}

/// What a beam needs on a surface, but for its shadows.
LightFeatures featuresOf(const Beam& beam, const BeamShape& shape, bool isComposed,
                         const Settings& settings) {
    LightFeatures features = 0;
    if (beam.web >= 0) {
        features |= kFeatureWeb;
    } else if (shape.exponent == 0.0) {
        features |= kFeatureFlat;
    }
    if (isComposed || (beam.gobo >= 0 && settings.gobos)) features |= kFeatureGobo;
    return features;
}

/// What a beam needs in the air besides, for its angle. Webs and the thesis' integrator need nothing.
LightFeatures inAir(const Beam& beam, const BeamShape& shape, const Camera& camera,
                    const Settings& settings) {
    if (beam.web >= 0 || settings.integrator == Integrator::kUniform) return 0;
    if (std::cos(shape.cutHalfAngleRad) < 0.0) return kFeatureBackwards;
    // A line knows the directions of its axis alone; what is wider is thin only where pixels are degrees
    // wide.
    constexpr double kWidestLineRad = 0.1;
    const bool isLine =
        shape.cutHalfAngleRad < kWidestLineRad && isThinOnScreen(beam, shape, camera, settings.height, 1.0);
    return isLine ? LightFeatures{kFeatureLine} : 0;
}

/// What the haze adds for every beam in the air.
LightFeatures airFeatures(const Scene& scene, const Settings& settings) {
    LightFeatures features = 0;
    if (scene.haze.noise.amount > 0.0f) features |= kFeatureNoise;
    if (settings.integrator == Integrator::kUniform) {
        features |= kFeatureUniform;
    } else if (settings.samples > 0) {
        features |= kFeatureSampled;
    }
    return features;
}

/// Beams that need the same, together.
std::vector<BeamGroup> groupBeams(const std::vector<int>& lit, const std::vector<LightFeatures>& features) {
    std::map<LightFeatures, std::vector<int>> groups;
    for (const int beam : lit) groups[features[static_cast<std::size_t>(beam)]].push_back(beam);
    std::vector<BeamGroup> list;
    for (auto& [needed, beams] : groups) list.push_back({needed, std::move(beams)});
    return list;
}

/// Lit lenses that are to be seen.
std::vector<int> seenLenses(const Scene& scene, const std::vector<int>& lit) {
    std::vector<int> seen;
    std::ranges::copy_if(lit, std::back_inserter(seen), [&scene](int index) {
        const Beam& beam = scene.beams[static_cast<std::size_t>(index)];
        return beam.showsLens && beam.lensRadiusM > 0.0;
    });
    return seen;
}

/// All that lenses ask is where the intensity comes from.
std::vector<BeamGroup> groupLenses(const std::vector<int>& lenses, std::vector<LightFeatures> features) {
    for (LightFeatures& feature : features) feature &= kFeatureWeb | kFeatureGobo;
    return groupBeams(lenses, features);
}

/// Fills the plan's part of shadows, and what the beams reach.
void planShadowsOf(const Scene& scene, const Camera& camera, const Settings& settings,
                   const std::vector<int>& lit, std::span<const MeshBounds> meshBounds, ScenePlan& plan) {
    const double pixelRad = 2.0 * viewTangent(camera, 1.0).y / settings.height;
    ShadowPlan shadows =
        planShadows(scene, lit, plan.shapes, meshBounds, {camera.positionM, pixelRad}, settings.shadows);
    plan.surfaceReach = std::move(shadows.reach);
    plan.shadowMaps = std::move(shadows.maps);
    plan.shadowsLeftOut = std::move(shadows.leftOut);
    std::vector<int> tiles;
    for (const ShadowMapPlan& map : plan.shadowMaps) {
        for (const ShadowFacePlan& face : map.faces) tiles.push_back(face.sizeTexels);
    }
    plan.shadowAtlasEdge = smallestAtlasEdge(tiles);
}

/// The lit beams that reach a surface.
std::vector<int> beamsOnSurfaces(const ScenePlan& plan) {
    std::vector<int> beams;
    std::ranges::copy_if(plan.lit, std::back_inserter(beams), [&plan](int beam) {
        return plan.surfaceReach[static_cast<std::size_t>(beam)].has_value();
    });
    return beams;
}

/// Integrals must cost more than what the grid takes besides them. Measured on a processor without a GPU,
/// docs/rendering.md.
bool gridPays(const ScenePlan& plan, const Settings& settings) {
    constexpr std::int64_t kManyPixels = 200'000;
    constexpr std::size_t kManyBeams = 16;
    const auto isCostly = [](const BeamGroup& group) {
        return (group.features & kFeatureNoise) != 0 || (group.features & kFeatureFlat) == 0;
    };
    return std::int64_t{settings.width} * settings.height >= kManyPixels &&
           (plan.lit.size() >= kManyBeams || std::ranges::any_of(plan.airGroups, isCostly));
}

int airStep(const ScenePlan& plan, const Settings& settings) {
    const int step = airQuality(settings).gridStep;
    return settings.airStep > 0 || gridPays(plan, settings) ? step : 1;
}

}  // namespace

std::vector<std::string> featureDefines(LightFeatures features) {
    std::vector<std::string> defines;
    for (const auto& [feature, name] : kFeatureNames) {
        if ((features & feature) != 0) defines.emplace_back(name);
    }
    return defines;
}

std::vector<LightFeatures> allAirVariants() {
    return variantsWithout(0);
}

std::vector<LightFeatures> allSurfaceVariants() {
    return variantsWithout(kAirOnly);
}

bool usesFeature(const ScenePlan& plan, LightFeature feature) {
    const auto needs = [feature](const BeamGroup& group) { return (group.features & feature) != 0; };
    return std::ranges::any_of(plan.airGroups, needs) || std::ranges::any_of(plan.surfaceGroups, needs) ||
           std::ranges::any_of(plan.lenses, needs);
}

bool takesProfileRules(LightFeatures group) {
    return (group & (kFeatureFlat | kFeatureWeb | kFeatureGobo | kFeatureUniform | kFeatureSampled |
                     kFeatureLine)) == 0;
}

bool usesProfileRules(const ScenePlan& plan) {
    const auto isRuled = [&plan](int beam) {
        return hasProfileRules(plan.shapes[static_cast<std::size_t>(beam)]);
    };
    return std::ranges::any_of(plan.airGroups, [&](const BeamGroup& group) {
        return takesProfileRules(group.features) && std::ranges::any_of(group.beams, isRuled);
    });
}

ScenePlan planScene(const Scene& scene, const Camera& camera, const Settings& settings,
                    std::span<const MeshBounds> meshBounds, std::span<const IesWeb> webs) {
    ScenePlan plan;
    for (std::size_t i = 0; i < scene.beams.size(); ++i) {
        const Beam& beam = scene.beams[i];
        plan.shapes.push_back(shapeOf(beam, webs, settings.gobos && needsPicture(beam)));
        const float brightest = std::max({beam.color.r, beam.color.g, beam.color.b});
        if (plan.shapes.back().peakCd > 0.0 && brightest > 0.0f) plan.lit.push_back(static_cast<int>(i));
    }
    plan.surfaces = !scene.instances.empty();
    plan.haze = hazeToIntegrate(scene.haze);
    plan.air = !plan.lit.empty() && plan.haze.scatteringPerM > 0.0f;
    plan.bloom = settings.bloom;
    const std::vector<int> lenses = seenLenses(scene, plan.lit);
    planShadowsOf(scene, camera, settings, plan.lit, meshBounds, plan);
    const std::vector<int> onSurfaces = beamsOnSurfaces(plan);
    plan.apertures =
        planApertures(scene, plan.air || !lenses.empty() ? plan.lit : onSurfaces, plan.shapes, settings);
    for (const int beam : plan.apertures.leftOut) {
        const auto index = static_cast<std::size_t>(beam);
        plan.shapes[index] = shapeOf(scene.beams[index], webs, false);
    }

    std::vector<LightFeatures> features(scene.beams.size(), 0);
    for (const int beam : plan.lit) {
        const auto index = static_cast<std::size_t>(beam);
        features[index] =
            featuresOf(scene.beams[index], plan.shapes[index], plan.apertures.ofBeam[index] >= 0, settings);
    }
    plan.lenses = groupLenses(lenses, features);
    for (const ShadowMapPlan& map : plan.shadowMaps) {
        features[static_cast<std::size_t>(map.beam)] |= kFeatureShadow | (map.isWide ? kFeatureWide : 0u);
    }
    plan.surfaceGroups = groupBeams(onSurfaces, features);
    if (!plan.air) return plan;
    const LightFeatures haze = airFeatures(scene, settings);
    for (const int beam : plan.lit) {
        const auto index = static_cast<std::size_t>(beam);
        features[index] |= haze | inAir(scene.beams[index], plan.shapes[index], camera, settings);
    }
    plan.airGroups = groupBeams(plan.lit, features);
    plan.airStep = airStep(plan, settings);
    return plan;
}

}  // namespace hazer::render
