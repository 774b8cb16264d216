// Between places in the world and places in the picture.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <span>

#include "render/scene.h"

namespace hazer::app {

/// Where a point of the world [m] is in a picture of `size`, from the picture's left upper corner, in the
/// unit of `size`. Empty if it lies behind the camera. It may lie outside the picture.
std::optional<glm::dvec2> placeInPicture(const render::Camera& camera, const glm::dvec2& size,
                                         const glm::dvec3& pointM);

/// Index of the point that appears nearest to `place`, if it appears within `reach` of it.
std::optional<std::size_t> pointAt(const render::Camera& camera, const glm::dvec2& size,
                                   const glm::dvec2& place, double reach,
                                   std::span<const glm::dvec3> pointsM);

}  // namespace hazer::app
