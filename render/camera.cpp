#include "render/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace hazer::render {

glm::dmat3 worldFromView(const Camera& camera) {
    glm::dvec3 forward = camera.targetM - camera.positionM;
    const double distance = glm::length(forward);
    forward = distance > 0.0 ? forward / distance : glm::dvec3(0.0, 1.0, 0.0);
    glm::dvec3 right = glm::cross(forward, camera.up);
    if (glm::length(right) < 1e-9) {
        right = glm::cross(forward,
                           std::abs(forward.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0));
    }
    right = glm::normalize(right);
    return {right, glm::cross(right, forward), -forward};
}

glm::dvec2 viewTangent(const Camera& camera, double aspect) {
    const double vertical = std::tan(0.5 * std::clamp(camera.verticalFovRad, 0.001, 3.0));
    return {vertical * aspect, vertical};
}

glm::dmat4 clipFromView(const Camera& camera, double aspect) {
    constexpr double kNearM = 0.05;
    constexpr double kFarM = 5000.0;
    return glm::perspective(2.0 * std::atan(viewTangent(camera, aspect).y), aspect, kNearM, kFarM);
}

}  // namespace hazer::render
