// What a frame needs, and what it can leave out. A pure function: scene in, plan out; no GL.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/aperture_plan.h"
#include "render/gpu_beam.h"
#include "render/ies_web.h"
#include "render/mesh.h"
#include "render/scene.h"
#include "render/shadow_plan.h"

namespace hazer::render {

/// Features of the shaders that draw beams. A group of beams is drawn with exactly those it needs.
enum LightFeature : std::uint32_t {
    kFeatureFlat = 1u << 0,  ///< The beam has no profile to evaluate.
    kFeatureGobo = 1u << 1,
    kFeatureShadow = 1u << 2,   ///< A caster stands in the cone.
    kFeatureNoise = 1u << 3,    ///< The haze is uneven; in the air only.
    kFeatureUniform = 1u << 4,  ///< The thesis' integrator; in the air only.
    kFeatureWeb = 1u << 5,      ///< A photometric web stands for the profile; never with kFeatureFlat.
    kFeatureCount = 1u << 6,    ///< Counts instead of drawing; in the air only.
    kFeatureWide = 1u << 7,     ///< Shadow maps all around a wide lamp; only with kFeatureShadow.
    kFeatureSampled = 1u << 8,  ///< As many nodes as the settings say; in the air only.
    /// The lamp shines backwards, too: all but a cone is lit. In the air only; webs and the thesis'
    /// integrator need no code for it.
    kFeatureBackwards = 1u << 9,
    /// So thin on the screen that pixels would miss it: drawn as a line where it is; in the air only.
    kFeatureLine = 1u << 10,
};
using LightFeatures = std::uint32_t;

/// The names that the shaders know features by.
std::vector<std::string> featureDefines(LightFeatures features);

/// Every combination that planScene can ask for in the air, and on surfaces.
std::vector<LightFeatures> allAirVariants();
std::vector<LightFeatures> allSurfaceVariants();

struct BeamGroup {
    LightFeatures features = 0;
    std::vector<int> beams;  ///< Indices into Scene::beams.
};

struct ScenePlan {
    std::vector<int> lit;   ///< Indices into Scene::beams of those that give light.
    bool surfaces = false;  ///< Anything with a mesh.
    bool air = false;       ///< Haze that scatters, and a lit beam.
    bool bloom = false;
    Haze haze;                         ///< What single scattering is integrated in, see hazeToIntegrate().
    std::vector<BeamShape> shapes;     ///< One per beam of the scene.
    AperturePlan apertures;            ///< Only of beams in whose way there is more than a gobo.
    std::vector<BeamGroup> lenses;     ///< Lit lenses to draw.
    std::vector<BeamGroup> airGroups;  ///< Empty without haze that scatters.
    /// Pixels between the nodes of the coarse grid of the air, see Settings::airStep; 1: there is no grid.
    /// The thesis' integrator and a given number of samples are drawn as they are, for comparison.
    int airStep = 1;
    std::vector<BeamGroup> surfaceGroups;   ///< Only of beams that reach a surface.
    std::vector<ShadowMapPlan> shadowMaps;  ///< Only of lamps with a caster in the cone.
    int shadowAtlasEdge = 0;                ///< Texels along both edges of the texture of all maps; 0: none.
    std::vector<int> shadowsLeftOut;        ///< Beams that shine through their casters, for want of memory.
    /// One per beam of the scene; none for a beam that lights no surface.
    std::vector<std::optional<SurfaceReach>> surfaceReach;
};

/// Is there a group of beams in the air, on surfaces or among the lenses that needs this feature?
bool usesFeature(const ScenePlan& plan, LightFeature feature);

/// Does the group's light in the air take quadrature rules for soft profiles (render/profile_rule.h), as far
/// as its beams have any?
bool takesProfileRules(LightFeatures group);

/// Does any beam in the air have such a rule?
bool usesProfileRules(const ScenePlan& plan);

/// `meshBounds[i]` encloses MeshId i in its own space, `webs[i]` is what WebId i stands for.
ScenePlan planScene(const Scene& scene, const Camera& camera, const Settings& settings,
                    std::span<const MeshBounds> meshBounds, std::span<const IesWeb> webs = {});

}  // namespace hazer::render
