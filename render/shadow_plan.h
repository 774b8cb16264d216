// Which lamps need shadow maps, where each map looks, what it must draw and how fine it is; and how far a
// lamp reaches. Pure functions; no GL.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "render/lamp_view.h"
#include "render/mesh.h"
#include "render/photometry.h"
#include "render/scene.h"

namespace hazer::render {

/// One map: a rectangle of directions, from the first caster on.
struct ShadowFacePlan {
    int face = 0;              ///< See faceFromLamp; 0 but for wide lamps.
    TangentRect rect;          ///< Encloses the casters; what lies beside it is lit.
    double nearM = 0.0;        ///< Of the first caster, along the face's axis; what lies before it is lit.
    int sizeTexels = 0;        ///< Along both edges of its tile; a power of two.
    std::vector<int> casters;  ///< Indices into Scene::instances.
};

/// The maps of one lamp.
struct ShadowMapPlan {
    int beam = 0;
    bool isWide = false;  ///< Looks around in up to six faces of a cube; else has one face, along the beam.
    std::vector<ShadowFacePlan> faces;  ///< Those with casters; at least one.
};

/// Where a lamp meets surfaces. Distances from the virtual apex [m]: along the axis, or for a wide lamp as
/// the crow flies.
struct SurfaceReach {
    double nearM = 0.0;
    double farM = 0.0;
    double deepM = 0.0;  ///< No surface is farther below the apex than this, in world Z; may be negative.
};

/// Beyond this half angle a lamp is wide: one plane would be stretched too much.
inline constexpr double kWideHalfAngleRad = 1.2217304763960306;  // 70 degrees
bool isWideLamp(const BeamShape& shape);

/// The rotation to a face of the cube around a lamp from the lamp's own frame; in the face's frame the face
/// is looked at along -Z. Face 0 looks along the beam, 1..4 along the lamp's +X, -X, +Y, -Y, 5 backwards.
/// shaders/include/shadow_frustum.glsl has the same.
glm::dmat3 faceFromLamp(int face);
inline constexpr int kCubeFaces = 6;

/// All maps together have at most this many texels of 4 bytes: 64 MiB.
inline constexpr std::int64_t kMostShadowTexels = std::int64_t{4096} * 4096;
/// No tile is smaller or larger.
inline constexpr int kSmallestShadowTile = 64;
inline constexpr int kLargestShadowTile = 2048;

/// How fine maps are to be.
struct ShadowDetail {
    glm::dvec3 cameraM{0.0};
    double pixelRad = 0.001;  ///< Angle of a pixel.
};

struct ShadowPlan {
    std::vector<std::optional<SurfaceReach>> reach;  ///< Per beam of the scene; none: it lights no surface.
    std::vector<ShadowMapPlan> maps;                 ///< Only of lamps with a caster in the cone.
    std::vector<int> leftOut;  ///< Beams that would need a map and have none for want of memory: the dimmest.
};

/// `lit` are indices into Scene::beams; `shapes[i]` belongs to beam i, `bounds[i]` to MeshId i. Without
/// `wantsMaps` only the reach is planned.
ShadowPlan planShadows(const Scene& scene, const std::vector<int>& lit, const std::vector<BeamShape>& shapes,
                       std::span<const MeshBounds> bounds, const ShadowDetail& detail, bool wantsMaps);

}  // namespace hazer::render
