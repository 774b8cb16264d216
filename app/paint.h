// What meshes of rigs and fixtures are painted with.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "render/scene.h"

namespace hazer::app {

/// The material of a mesh's paint (linear Rec. 709, as render::PaintedMesh has it); `otherwise` where it has
/// none. White paint reflects 80 % of the light, and no paint more.
render::Material materialOf(const std::optional<glm::vec3>& paint, const render::Color& otherwise);

}  // namespace hazer::app
