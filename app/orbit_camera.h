// A camera that a hand moves around a point.
#pragma once

#include <glm/glm.hpp>

#include "render/scene.h"

namespace hazer::app {

/// Looks at a target from a distance; world Z stays up in the picture. Drags are shares of the picture's
/// height, x to the right and y down, as a mouse moves.
class OrbitCamera {
 public:
    /// Stands where `camera` stands and looks where it looks, as far as the limits below allow.
    explicit OrbitCamera(const render::Camera& camera);

    /// Turns the world with the hand about the target; a drag over the whole height is half a turn. Stops
    /// kMaxElevationRad above and below the horizon, so that the picture never flips over.
    void orbit(const glm::dvec2& drag);

    /// Moves camera and target alike, so that what is at the target stays under the hand.
    void pan(const glm::dvec2& drag);

    /// One step of a mouse wheel brings the target a tenth nearer; negative steps go away from it.
    void dolly(double steps);

    /// Backs off until a ball fits in the picture, without turning, but never looks from below: a stage has a
    /// floor. `radiusM` > 0, `aspect` is width / height.
    void frame(const glm::dvec3& centreM, double radiusM, double aspect);

    void setVerticalFov(double fovRad);
    double verticalFovRad() const { return verticalFovRad_; }
    double distanceM() const { return distanceM_; }

    render::Camera camera() const;

    static constexpr double kMaxElevationRad = 1.553;  ///< 89 degrees.
    static constexpr double kMinDistanceM = 0.2;
    static constexpr double kMaxDistanceM = 2000.0;
    static constexpr double kMinFovRad = 0.05;
    static constexpr double kMaxFovRad = 2.5;

 private:
    glm::dvec3 towardsCamera() const;

    glm::dvec3 targetM_;
    double distanceM_;
    double azimuthRad_;    ///< From +X towards +Y, of the camera as seen from the target.
    double elevationRad_;  ///< Above the horizon, of the camera as seen from the target.
    double verticalFovRad_;
};

}  // namespace hazer::app
