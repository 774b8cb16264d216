// What the oracle says about the light in the air at pixels of a picture.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "render/mesh.h"
#include "render/scene.h"

namespace hazer::app {

/// Luminance-like sum of the channels [cd/m^2] of the light in the air at the centres of `pixels` (x, y; row
/// 0 on top) of a picture of `size` x `size`, without gobos, webs and noise; where a beam is drawn as a line,
/// the mean under a pixel's filter. Empty if hazer was built without the oracle (HAZER_ORACLE=OFF). Negative
/// where nothing stands for the pixel: on an outline of a body, and where a line gives way to rays.
std::vector<double> oracleAir(const render::Scene& scene, const render::Camera& camera, int size,
                              const std::vector<render::Mesh>& meshes, const std::vector<glm::ivec2>& pixels);

}  // namespace hazer::app
