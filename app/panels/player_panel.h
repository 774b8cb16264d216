// The panel of recordings that play: stop, scrub, loop, follow a time code.
#pragma once

#include "app/session.h"

namespace hazer::app {

/// Draws nothing if the show plays no recording.
void drawPlayers(Session& session);

}  // namespace hazer::app
