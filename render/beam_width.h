// How wide a beam is on the screen.
#pragma once

#include "render/photometry.h"
#include "render/scene.h"

namespace hazer::render {

/// Would samples `stepPx` pixels apart miss a good part of the beam (more than about 24 pixels of its
/// length)? `height` is that of the picture [px].
bool isThinOnScreen(const Beam& beam, const BeamShape& shape, const Camera& camera, int height,
                    double stepPx);

}  // namespace hazer::render
