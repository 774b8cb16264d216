// The way to a window, where hazer was built with one and a display is there.
#pragma once

#include <functional>
#include <optional>

#include "app/session.h"

namespace hazer::app {

/// Can a window be opened: was hazer built with one, and does DISPLAY or WAYLAND_DISPLAY name a display?
bool hasDisplay();

/// Opens a window, runs the show in it until it is closed or `frames` pictures (if given) have been shown,
/// and returns the program's exit code. `started` is called once the session runs. Throws render::NoGlError
/// if there is no window to be had, and what Session throws.
int showInWindow(Show show, const SessionOptions& options, const std::function<void(Session&)>& started,
                 std::optional<int> frames = std::nullopt);

}  // namespace hazer::app
