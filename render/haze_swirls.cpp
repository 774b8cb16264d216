#include "render/haze_swirls.h"

#include <glm/gtc/quaternion.hpp>

#include "render/noise_volume.h"

namespace hazer::render {
namespace {

/// How fast the waves that stir the smoke go round; no two in step.
constexpr glm::dvec3 kStirHz(0.037, 0.029, 0.043);

/// By 75 degrees about (0.6, -0.48, 0.64).
const glm::dmat3& askew() {
    static const glm::dmat3 kAskew =
        glm::mat3_cast(glm::angleAxis(glm::radians(75.0), glm::dvec3(0.6, -0.48, 0.64)));
    return kAskew;
}

glm::vec3 fraction(const glm::dvec3& v) {
    return glm::vec3(v - glm::floor(v));
}

}  // namespace

HazeSwirls hazeSwirls(const HazeNoise& noise, const glm::dvec3& cameraM, double timeS) {
    HazeSwirls swirls;
    swirls.noiseFromWorld = askew();
    swirls.periodM = kNoiseCells * static_cast<double>(noise.scaleM);
    swirls.origin = fraction(askew() * ((cameraM - glm::dvec3(noise.windMps) * timeS) / swirls.periodM));
    swirls.wave = fraction(kStirHz * (static_cast<double>(noise.turbulence) * timeS));
    return swirls;
}

}  // namespace hazer::render
