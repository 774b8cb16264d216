// Haze, scene light, set and exposure.
#pragma once

#include "app/session.h"

namespace hazer::app {

/// `ofShow` is what "as in the show" goes back to.
void drawHazeControls(SceneControls& controls, const SceneControls& ofShow);
void drawSetControls(SceneControls& controls, const SceneControls& ofShow);

}  // namespace hazer::app
