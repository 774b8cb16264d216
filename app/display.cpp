#include "app/display.h"

#include <cstdlib>
#include <utility>

#include "render/error.h"
#ifdef HAZER_HAS_WINDOW
#include "app/window.h"
#include "app/window_loop.h"
#endif

namespace hazer::app {
namespace {

[[maybe_unused]] bool isSet(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != '\0';
}

}  // namespace

#ifdef HAZER_HAS_WINDOW

bool hasDisplay() {
    return isSet("DISPLAY") || isSet("WAYLAND_DISPLAY");
}

int showInWindow(Show show, const SessionOptions& options, const std::function<void(Session&)>& started,
                 std::optional<int> frames) {
    if (!hasDisplay()) {
        throw render::NoGlError(
            "there is no display for a window (DISPLAY and WAYLAND_DISPLAY are empty); 'hazer render' draws "
            "without one");
    }
    Window window(show.title);
    Session session(std::move(show), options);
    if (started) started(session);
    return runWindow(window, session, frames);
}

#else

bool hasDisplay() {
    return false;
}

int showInWindow(Show, const SessionOptions&, const std::function<void(Session&)>&, std::optional<int>) {
    throw render::NoGlError(
        "this hazer was built without a window (HAZER_WINDOW=OFF); 'hazer render' draws pictures without "
        "one");
}

#endif

}  // namespace hazer::app
