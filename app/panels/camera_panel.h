// Where the picture is seen from.
#pragma once

#include "app/show.h"
#include "app/window_state.h"

namespace hazer::app {

void drawCameraControls(const Show& show, WindowState& state);

}  // namespace hazer::app
