// A window with an OpenGL 4.1 core context, by GLFW.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

namespace hazer::app {

/// A key as GLFW numbers it, such as GLFW_KEY_TAB.
using Key = int;

/// Opens on the screen with its context current on this thread, for its lifetime. One at a time.
class Window {
 public:
    /// Is 1600 x 900, or smaller where the monitor is. Throws render::NoGlError if there is no display, or
    /// none that offers OpenGL 4.1 core.
    explicit Window(const std::string& title);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Has somebody asked to close it?
    bool shouldClose() const;

    /// Pixels to draw on; 0 while the window is minimised.
    glm::ivec2 framebufferSize() const;

    /// How much larger than on a plain screen text should be, as the desktop says.
    float contentScale() const;

    /// Shows what was drawn at the monitor's next refresh, and takes the events that have come.
    void swap();

    /// Takes events without showing anything; returns when one comes, or after `timeoutS`.
    void waitForEvents(double timeoutS);

    /// Keys that went down since the last call, oldest first.
    std::vector<Key> takePressedKeys();

    GLFWwindow* glfw() const;

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace hazer::app
