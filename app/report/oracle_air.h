// What the oracle says about the light in the air at pixels of a picture.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "render/mesh.h"
#include "render/scene.h"

namespace hazer::app {

/// Luminance-like sum of the channels [cd/m^2] of the light in the air at the centres of `pixels` (x, y; row
/// 0 on top) of a picture of `size` x `size`, without gobos, webs and noise. Empty if hazer was built without
/// the oracle (HAZER_ORACLE=OFF). Pixels on an outline of a body are negative: no single ray stands for them.
std::vector<double> oracleAir(const render::Scene& scene, const render::Camera& camera, int size,
                              const std::vector<render::Mesh>& meshes, const std::vector<glm::ivec2>& pixels);

}  // namespace hazer::app
