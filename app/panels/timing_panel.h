// How long a frame takes, and what takes it.
#pragma once

#include "app/session.h"
#include "app/window_frame_times.h"

namespace hazer::app {

void drawTimings(Session& session, const WindowFrameTimes& frameTimes);

}  // namespace hazer::app
