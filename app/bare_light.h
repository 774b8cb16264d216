// The bare lights of a show as beams of the renderer.
#pragma once

#include <vector>

#include "app/show.h"
#include "render/renderer.h"
#include "render/scene.h"

namespace hazer::app {

/// One beam for each light, in the show's order. Gives their pictures to the renderer, each file once. Throws
/// ShowError if one cannot be read.
std::vector<render::Beam> lightBeams(const Show& show, render::Renderer& renderer);

}  // namespace hazer::app
