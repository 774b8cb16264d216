// The two columns of panels: fixtures at the left, scene and machine at the right.
#pragma once

#include "app/session.h"
#include "app/window_state.h"
#include "app/window_thumbnails.h"

namespace hazer::app {

void drawSidePanels(Session& session, WindowState& state, WindowThumbnails& thumbnails);

}  // namespace hazer::app
