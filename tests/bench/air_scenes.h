// Scenes that show one feature of the light in the air each: bare beams over black surfaces, so that a
// picture holds the air alone.
#pragma once

#include <string>
#include <vector>

#include "render/renderer.h"

namespace hazer::bench {

struct AirScene {
    std::string name;
    render::Scene scene;
    render::Camera camera;
};

/// Adds what the scenes need (meshes, a gobo) to the renderer.
std::vector<AirScene> makeAirScenes(render::Renderer& renderer);

}  // namespace hazer::bench
