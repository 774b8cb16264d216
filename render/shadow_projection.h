// From directions out of a lamp to texels of its tile in the shadow atlas. No GL.
#pragma once

#include <glm/glm.hpp>

#include "render/shadow_atlas.h"
#include "render/shadow_plan.h"

namespace hazer::render {

/// A perspective with its own, off-centre window. Depth is near / axial distance: 1 at the near plane, 0 at
/// infinity, so that no far plane is needed.
struct ShadowProjection {
    TangentRect
        window;  ///< What the tile shows within its rim: the planned rectangle and two texels around it.
    double nearM = 0.0;
    int sizeTexels = 0;  ///< Of the tile.
    glm::dvec2 texelsPerTangent{0.0};
};

/// A rim of this many texels around a tile is never drawn: what is looked up beside the window is lit.
inline constexpr int kShadowRimTexels = 1;

ShadowProjection shadowProjection(const ShadowFacePlan& face);

/// To the clip space of the tile without its rim, from the frame of its face.
glm::dmat4 clipFromFace(const ShadowProjection& projection);

/// Of one map, from the world.
glm::dmat4 clipFromWorld(const Beam& beam, const BeamShape& shape, int face,
                         const ShadowProjection& projection);

/// How the shaders find a map; shaders/include/shadow.glsl takes these as three texels.
struct ShadowFaceRecord {
    glm::vec4 map{0.0f};     ///< Tangent to texel of the atlas: scale x, y, offset x, y.
    glm::vec4 tile{0.0f};    ///< Lowest texel x, y, edge - 1 [texels], near [m].
    glm::vec4 window{0.0f};  ///< Lowest tangent x, y, highest tangent x, y.
};

ShadowFaceRecord faceRecord(const ShadowProjection& projection, const ShadowTile& tile);

/// Of a face where nothing casts.
ShadowFaceRecord emptyFaceRecord();

/// How many records a lamp has.
int faceRecordCount(const ShadowMapPlan& map);

}  // namespace hazer::render
