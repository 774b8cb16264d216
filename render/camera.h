// The camera's matrices, in double.
#pragma once

#include <glm/glm.hpp>

#include "render/scene.h"

namespace hazer::render {

/// Rotation only: columns are the camera's right, up and backward direction in the world. A camera that looks
/// along its own `up` takes another up.
glm::dmat3 worldFromView(const Camera& camera);

/// Perspective with depth -1..1 between 5 cm and 5 km.
glm::dmat4 clipFromView(const Camera& camera, double aspect);

/// Tangents of half the horizontal and vertical field of view.
glm::dvec2 viewTangent(const Camera& camera, double aspect);

}  // namespace hazer::render
