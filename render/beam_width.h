// How wide a beam is on the screen: what samples some pixels apart would miss of it.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "render/photometry.h"
#include "render/scene.h"

namespace hazer::render {

/// Is the beam narrower than two of these steps over most of its length? `height` is that of the picture
/// [px].
bool isThinOnScreen(const Beam& beam, const BeamShape& shape, const Camera& camera, int height,
                    double stepPx);

/// A square of pixels; x to the right, y up, from the lower left corner of the picture. It may lie outside.
struct PixelSquare {
    glm::dvec2 centerPx{0.0};
    double halfEdgePx = 0.0;
};

/// The surroundings of the lens in which a beam that is not thin as a whole is narrower than two steps; none
/// if there is no such place in front of the camera.
std::optional<PixelSquare> thinSurroundings(const Beam& beam, const BeamShape& shape, const Camera& camera,
                                            glm::ivec2 pictureSize, double stepPx);

}  // namespace hazer::render
