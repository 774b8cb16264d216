#include "app/window_loop.h"

#include <chrono>

#include "app/commands/command.h"
#include "app/interrupt.h"
#include "app/panels/help_panel.h"
#include "app/panels/side_panels.h"
#include "app/window_gui.h"
#include "app/window_input.h"
#include "app/window_state.h"
#include "app/window_thumbnails.h"

namespace hazer::app {
namespace {

/// Seconds since the last call.
class Stopwatch {
 public:
    double lapS() {
        const protocol::TimePoint now = protocol::Clock::now();
        const double lapS = std::chrono::duration<double>(now - last_).count();
        last_ = now;
        return lapS;
    }

 private:
    protocol::TimePoint last_ = protocol::Clock::now();
};

void drawPicture(Window& window, Session& session, const WindowState& state) {
    const glm::ivec2 shown = window.framebufferSize();
    const glm::ivec2 drawn = state.resolution.drawnSize(shown);
    session.settings().width = drawn.x;
    session.settings().height = drawn.y;
    session.settings().waitForTables = false;
    session.camera() = state.camera.camera();
    session.draw();
    session.renderer().present(0, shown.x, shown.y);
}

void showFrame(Window& window, WindowGui& gui, Session& session, WindowState& state,
               WindowThumbnails& thumbnails) {
    gui.begin();
    followKeys(window.takePressedKeys(), session.show(), state);
    followMouse(session, state);
    if (state.showsPanels) {
        markSelected(session, state);
        drawSidePanels(session, state, thumbnails);
    }
    if (state.showsHelp) drawHelpPanel(state.showsHelp);
    drawPicture(window, session, state);
    gui.draw();
    window.swap();
}

/// What the passes of a recent picture took together; 0 until a time has come back.
double pictureMs(const render::Renderer& renderer) {
    double sumMs = 0.0;
    for (const render::PassTime& pass : renderer.passTimes()) sumMs += pass.milliseconds;
    return sumMs;
}

void takeTimes(double frameS, const render::Renderer& renderer, WindowState& state) {
    constexpr double kMsPerS = 1000.0;
    state.frameTimes.add(frameS * kMsPerS);
    state.resolution.add(pictureMs(renderer));
}

}  // namespace

int runWindow(Window& window, Session& session, std::optional<int> frames) {
    const Interrupt interrupt;
    WindowGui gui(window);
    WindowThumbnails thumbnails;
    WindowState state(session);
    Stopwatch stopwatch;
    for (int shown = 0; !window.shouldClose() && !interrupt.asked() && shown != frames;) {
        const double frameS = stopwatch.lapS();
        session.advance(frameS);
        if (window.framebufferSize().x == 0 || window.framebufferSize().y == 0) {
            constexpr double kIdleS = 0.1;
            window.waitForEvents(kIdleS);
            continue;
        }
        if (shown > 0) takeTimes(frameS, session.renderer(), state);
        showFrame(window, gui, session, state, thumbnails);
        ++shown;
    }
    return kExitOk;
}

}  // namespace hazer::app
