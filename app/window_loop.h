// A show in its window, frame by frame.
#pragma once

#include <optional>

#include "app/session.h"
#include "app/window.h"

namespace hazer::app {

/// Runs the show until the window is closed, Ctrl-C is pressed, or `frames` pictures (if given) have been
/// shown. Returns the program's exit code.
int runWindow(Window& window, Session& session, std::optional<int> frames);

}  // namespace hazer::app
