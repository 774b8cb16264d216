// What a frame needs, and what it can leave out. A pure function: scene in, plan out; no GL.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "render/gpu_beam.h"
#include "render/mesh.h"
#include "render/scene.h"

namespace hazer::render {

/// Features of the light shader. A group of beams is drawn with exactly those it needs.
enum LightFeature : std::uint32_t {
    kFeatureAir = 1u << 0,       ///< Haze scatters.
    kFeatureSurfaces = 1u << 1,  ///< There is something to light.
    kFeatureFlat = 1u << 2,      ///< The beam has no profile to evaluate.
    kFeatureGobo = 1u << 3,
    kFeatureShadow = 1u << 4,   ///< A caster stands in the cone.
    kFeatureNoise = 1u << 5,    ///< The haze is uneven.
    kFeatureUniform = 1u << 6,  ///< The thesis' integrator.
};
using LightFeatures = std::uint32_t;

/// The names that the shaders know features by.
std::vector<std::string> featureDefines(LightFeatures features);

/// Every combination that planScene can ask for.
std::vector<LightFeatures> allLightVariants();

struct BeamGroup {
    LightFeatures features = 0;
    std::vector<int> beams;  ///< Indices into Scene::beams.
};

struct ShadowMapPlan {
    int beam = 0;
    ShadowProjection projection;
    std::vector<int> casters;  ///< Indices into Scene::instances, in the cone only.
};

struct ScenePlan {
    bool surfaces = false;  ///< Anything with a mesh.
    bool air = false;       ///< Haze that scatters, and a lit beam.
    bool lenses = false;    ///< A lit lens with a size.
    bool bloom = false;
    std::vector<BeamShape> shapes;  ///< One per beam of the scene.
    std::vector<BeamGroup> groups;
    std::vector<ShadowMapPlan> shadowMaps;  ///< Layer i of the map array is shadowMaps[i].
    int shadowMapSize = 0;                  ///< Texels along an edge; 0: none.
};

/// At most this many lamps have a shadow map at once; further ones (the dimmest) shine through.
inline constexpr int kMaxShadowMaps = 64;

/// `meshBounds[i]` is the bounding sphere of MeshId i in its own space.
ScenePlan planScene(const Scene& scene, const Settings& settings, std::span<const BoundingSphere> meshBounds);

}  // namespace hazer::render
