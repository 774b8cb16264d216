#include "render/beam_width.h"

#include <algorithm>
#include <cmath>

#include "render/camera.h"

namespace hazer::render {

bool isThinOnScreen(const Beam& beam, const BeamShape& shape, const Camera& camera, int height,
                    double stepPx) {
    constexpr double kThinLengthPx = 24.0;
    if (shape.cutHalfAngleRad > 0.8) return false;
    const double pixelRad = 2.0 * viewTangent(camera, 1.0).y / height;
    const double opening = 2.0 * std::tan(shape.cutHalfAngleRad);
    const double wantedPx = 2.0 * stepPx;
    // Far away along the view the beam's width tends to its opening angle.
    if (opening / pixelRad < wantedPx) return true;
    const double distanceM = std::max(glm::distance(camera.positionM, beam.lensPositionM), 1e-6);
    const double lensPx = shape.apexToLensM * opening / distanceM / pixelRad;
    return (wantedPx - lensPx) / opening > kThinLengthPx;
}

}  // namespace hazer::render
