// Dear ImGui on a window: set up, begun and drawn once a frame, taken down.
#pragma once

#include "app/window.h"

namespace hazer::app {

/// Needs the window's context current for its whole life. One at a time.
class WindowGui {
 public:
    explicit WindowGui(Window& window);
    ~WindowGui();
    WindowGui(const WindowGui&) = delete;
    WindowGui& operator=(const WindowGui&) = delete;

    /// Starts a frame: from here to draw(), panels can be made. Follows the window to another screen's scale.
    void begin();

    /// Draws the panels over what is in the current framebuffer.
    void draw();

 private:
    Window& window_;
    float contentScale_;
};

}  // namespace hazer::app
