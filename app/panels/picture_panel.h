// How the picture is made: exposure, resolution, and what may be left out.
#pragma once

#include "app/window_resolution.h"
#include "render/scene.h"

namespace hazer::app {

void drawPictureControls(render::Settings& settings, WindowResolution& resolution);

}  // namespace hazer::app
