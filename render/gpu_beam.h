// A beam as the shaders take it: the C++ twin of shaders/include/beam_input.glsl.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>

#include "render/gobo_table.h"
#include "render/photometry.h"
#include "render/scene.h"
#include "render/shadow_plan.h"

namespace hazer::render {

struct GpuBeam {
    glm::vec4 row0, row1, row2;
    glm::vec4 light;
    glm::vec4 cone;
    glm::vec4 gobo;
    glm::vec4 shadow;
    glm::vec4 lens;
};
static_assert(sizeof(GpuBeam) == 8 * 16);
static_assert(offsetof(GpuBeam, light) == 48 && offsetof(GpuBeam, lens) == 112);

/// Where the virtual apex of a beam is, world [m].
glm::dvec3 apexPosition(const Beam& beam, const BeamShape& shape);

/// What the plan of shadows says of a beam.
struct BeamShadow {
    int firstFace = -1;  ///< Of its records, see ShadowTextures; -1: no map.
    SurfaceReach reach;
};

/// The picture that a beam shines through.
struct BeamPicture {
    int layer = -1;  ///< Of the gobos' texture; -1: none.
    double rotationRad = 0.0;
};

/// Packs a beam for a camera. Positions are subtracted in double, so that a stage a kilometre from the origin
/// loses nothing.
GpuBeam packBeam(const Beam& beam, const BeamShape& shape, const Camera& camera, const BeamShadow& shadow,
                 const BeamPicture& picture, const GoboTableSlot& goboTable);

}  // namespace hazer::render
