// All faders of one fixture.
#pragma once

#include "app/window_state.h"
#include "app/window_thumbnails.h"
#include "fixtures/fixture.h"

namespace hazer::app {

void drawFaderPanel(fixtures::Fixture& fixture, WindowState& state, WindowThumbnails& thumbnails);

}  // namespace hazer::app
