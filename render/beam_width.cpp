#include "render/beam_width.h"

#include <algorithm>
#include <cmath>

#include "render/camera.h"

namespace hazer::render {
namespace {

/// Half angle up to which a beam's own width limits what is seen of it.
constexpr double kWideRad = 0.8;

/// Width of the beam at its lens and how fast it grows, both as seen on the screen.
struct ScreenWidth {
    double lensPx = 0.0;
    double opening = 0.0;       ///< px per px of length
    double thinLengthPx = 0.0;  ///< From the lens to where the beam is two steps wide.
};

double pixelAngle(const Camera& camera, int height) {
    return 2.0 * viewTangent(camera, 1.0).y / height;
}

ScreenWidth screenWidth(const Beam& beam, const BeamShape& shape, const Camera& camera, int height,
                        double stepPx) {
    ScreenWidth width;
    width.opening = 2.0 * std::tan(std::min(shape.cutHalfAngleRad, kWideRad));
    const double distanceM = std::max(glm::distance(camera.positionM, beam.lensPositionM), 1e-6);
    width.lensPx = shape.apexToLensM * width.opening / distanceM / pixelAngle(camera, height);
    width.thinLengthPx = std::max(2.0 * stepPx - width.lensPx, 0.0) / width.opening;
    return width;
}

}  // namespace

bool isThinOnScreen(const Beam& beam, const BeamShape& shape, const Camera& camera, int height,
                    double stepPx) {
    constexpr double kThinLengthPx = 48.0;
    const ScreenWidth width = screenWidth(beam, shape, camera, height, stepPx);
    // Far away along the view a beam's width tends to its opening angle.
    return width.opening < 2.0 * stepPx * pixelAngle(camera, height) || width.thinLengthPx > kThinLengthPx;
}

std::optional<PixelSquare> thinSurroundings(const Beam& beam, const BeamShape& shape, const Camera& camera,
                                            glm::ivec2 pictureSize, double stepPx) {
    const ScreenWidth width = screenWidth(beam, shape, camera, pictureSize.y, stepPx);
    if (width.thinLengthPx <= 0.0) return std::nullopt;
    const glm::dvec3 view = glm::transpose(worldFromView(camera)) * (beam.lensPositionM - camera.positionM);
    if (view.z > -1e-3) return std::nullopt;
    const glm::dvec2 size(pictureSize);
    const glm::dvec2 tangent = viewTangent(camera, size.x / size.y);
    const glm::dvec2 place = glm::dvec2(view) / (-view.z * tangent);
    return PixelSquare{0.5 * (place + 1.0) * size, width.thinLengthPx + 0.5 * width.lensPx + stepPx};
}

}  // namespace hazer::render
