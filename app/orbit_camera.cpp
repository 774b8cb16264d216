#include "app/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "render/camera.h"

namespace hazer::app {
namespace {

constexpr double kDollyPerStep = 0.9;
constexpr double kLowestFramingRad = 0.1;  ///< Above the horizon.

double clampElevation(double elevationRad) {
    return std::clamp(elevationRad, -OrbitCamera::kMaxElevationRad, OrbitCamera::kMaxElevationRad);
}

double clampDistance(double distanceM) {
    return std::clamp(distanceM, OrbitCamera::kMinDistanceM, OrbitCamera::kMaxDistanceM);
}

double clampFov(double fovRad) {
    return std::clamp(fovRad, OrbitCamera::kMinFovRad, OrbitCamera::kMaxFovRad);
}

}  // namespace

OrbitCamera::OrbitCamera(const render::Camera& camera)
    : targetM_(camera.targetM),
      distanceM_(clampDistance(glm::length(camera.positionM - camera.targetM))),
      verticalFovRad_(clampFov(camera.verticalFovRad)) {
    const glm::dvec3 backward = render::worldFromView(camera)[2];
    azimuthRad_ = std::atan2(backward.y, backward.x);
    elevationRad_ = clampElevation(std::asin(std::clamp(backward.z, -1.0, 1.0)));
    // Where the distance had to change, it is the target that moves: the person stays where the show put
    // them.
    targetM_ = camera.positionM - distanceM_ * towardsCamera();
}

glm::dvec3 OrbitCamera::towardsCamera() const {
    return {std::cos(elevationRad_) * std::cos(azimuthRad_), std::cos(elevationRad_) * std::sin(azimuthRad_),
            std::sin(elevationRad_)};
}

void OrbitCamera::orbit(const glm::dvec2& drag) {
    constexpr double kTurn = glm::two_pi<double>();
    azimuthRad_ = std::remainder(azimuthRad_ - drag.x * glm::pi<double>(), kTurn);
    elevationRad_ = clampElevation(elevationRad_ + drag.y * glm::pi<double>());
}

void OrbitCamera::pan(const glm::dvec2& drag) {
    const glm::dmat3 worldFromView = render::worldFromView(camera());
    const double heightAtTargetM = 2.0 * distanceM_ * std::tan(0.5 * verticalFovRad_);
    targetM_ += heightAtTargetM * (drag.y * worldFromView[1] - drag.x * worldFromView[0]);
}

void OrbitCamera::dolly(double steps) {
    distanceM_ = clampDistance(distanceM_ * std::pow(kDollyPerStep, steps));
}

void OrbitCamera::frame(const glm::dvec3& centreM, double radiusM, double aspect) {
    const double narrowerTangent = std::tan(0.5 * verticalFovRad_) * std::min(1.0, aspect);
    targetM_ = centreM;
    elevationRad_ = std::max(elevationRad_, kLowestFramingRad);
    distanceM_ = clampDistance(radiusM / std::sin(std::atan(narrowerTangent)));
}

void OrbitCamera::setVerticalFov(double fovRad) {
    verticalFovRad_ = clampFov(fovRad);
}

render::Camera OrbitCamera::camera() const {
    render::Camera camera;
    camera.targetM = targetM_;
    camera.positionM = targetM_ + distanceM_ * towardsCamera();
    camera.verticalFovRad = verticalFovRad_;
    return camera;
}

}  // namespace hazer::app
