// Which lamps need a shadow map, how it looks out of the lamp, and what it must draw. A pure function; no GL.
#pragma once

#include <span>
#include <vector>

#include "render/gpu_beam.h"
#include "render/mesh.h"
#include "render/scene.h"

namespace hazer::render {

struct ShadowMapPlan {
    int beam = 0;
    ShadowProjection projection;
    std::vector<int> casters;  ///< Indices into Scene::instances, in the cone only.
};

/// At most this many lamps have a shadow map at once; further ones (the dimmest) shine through.
inline constexpr int kMaxShadowMaps = 64;

/// One plan for each beam of `lit` (indices into Scene::beams) with a caster inside its cone.
/// `shapes[i]` belongs to beam i; `meshBounds[i]` is the bounding sphere of MeshId i in its own space.
std::vector<ShadowMapPlan> planShadows(const Scene& scene, const std::vector<int>& lit,
                                       const std::vector<BeamShape>& shapes,
                                       std::span<const BoundingSphere> meshBounds);

}  // namespace hazer::render
