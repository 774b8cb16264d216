// Where a camera stands in the noise of the haze, at a moment.
#pragma once

#include <glm/glm.hpp>

#include "render/scene.h"

namespace hazer::render {

/// What shaders/include/haze_swirls.glsl needs to know. A period is the edge of the noise's volume.
struct HazeSwirls {
    /// A rotation: the volume lies askew to the world, so that no truss, floor or row of lamps runs along its
    /// repetitions.
    glm::dmat3 noiseFromWorld{1.0};
    glm::vec3 origin{0.0f};  ///< The camera, in periods, 0..1.
    double periodM = 1.0;
    glm::vec3 wave{0.0f};  ///< Phases of the waves that stir the haze, 0..1.
};

/// A function of the time alone, to the same digits after a week: the wind carries the noise by its velocity
/// times the time; turbulence is how fast the waves that stir it go round, so that without it the noise only
/// drifts.
HazeSwirls hazeSwirls(const HazeNoise& noise, const glm::dvec3& cameraM, double timeS);

}  // namespace hazer::render
