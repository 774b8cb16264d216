// The fixtures of the show, one of them selected.
#pragma once

#include "app/patch.h"
#include "app/window_state.h"

namespace hazer::app {

void drawFixtureList(Patch& patch, WindowState& state);

}  // namespace hazer::app
