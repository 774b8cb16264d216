#include "app/window.h"

#include <epoxy/gl.h>
// After epoxy, so that GLFW brings no OpenGL header of its own.
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "render/error.h"

namespace hazer::app {
namespace {

constexpr glm::ivec2 kPreferredSize{1600, 900};

[[noreturn]] void fail(const char* what) {
    const char* reason = nullptr;
    glfwGetError(&reason);
    throw render::NoGlError(fmt::format(
        "{} ({}); check the display and the graphics driver, or let 'hazer render' draw without a window",
        what, reason == nullptr ? "no reason given" : reason));
}

/// The library as long as it is needed.
struct Glfw {
    Glfw() {
        if (glfwInit() != GLFW_TRUE) fail("no window can be opened");
    }
    ~Glfw() { glfwTerminate(); }
    Glfw(const Glfw&) = delete;
    Glfw& operator=(const Glfw&) = delete;
};

/// The preferred size, as far as the first monitor's desktop has room for it.
glm::ivec2 sizeThatFits() {
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    if (monitor == nullptr) return kPreferredSize;
    glm::ivec2 place{0};
    glm::ivec2 room{0};
    glfwGetMonitorWorkarea(monitor, &place.x, &place.y, &room.x, &room.y);
    return room.x > 0 && room.y > 0 ? glm::min(kPreferredSize, room) : kPreferredSize;
}

GLFWwindow* open(const std::string& title) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);  // macOS has core contexts in this form only
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);   // so that drivers report errors
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    const glm::ivec2 size = sizeThatFits();
    return glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
}

}  // namespace

struct Window::Impl {
    explicit Impl(const std::string& title) : window(open(title)) {
        if (window == nullptr) fail("no window with OpenGL 4.1 can be opened");
    }
    ~Impl() { glfwDestroyWindow(window); }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    static void onKey(GLFWwindow* window, int key, int /*scancode*/, int action, int /*modifiers*/) {
        if (action != GLFW_PRESS) return;
        static_cast<Impl*>(glfwGetWindowUserPointer(window))->pressedKeys.push_back(key);
    }

    Glfw glfw;
    GLFWwindow* window;
    std::vector<Key> pressedKeys;
};

Window::Window(const std::string& title) : impl_(std::make_unique<Impl>(title)) {
    glfwSetWindowUserPointer(impl_->window, impl_.get());
    glfwSetKeyCallback(impl_->window, Impl::onKey);
    glfwMakeContextCurrent(impl_->window);
    glfwSwapInterval(1);
}

Window::~Window() = default;

bool Window::shouldClose() const {
    return glfwWindowShouldClose(impl_->window) == GLFW_TRUE;
}

glm::ivec2 Window::framebufferSize() const {
    glm::ivec2 size{0};
    glfwGetFramebufferSize(impl_->window, &size.x, &size.y);
    return glfwGetWindowAttrib(impl_->window, GLFW_ICONIFIED) == GLFW_TRUE ? glm::ivec2(0) : size;
}

float Window::contentScale() const {
    glm::vec2 scale{1.0f};
    glfwGetWindowContentScale(impl_->window, &scale.x, &scale.y);
    return std::max(1.0f, scale.y);
}

void Window::swap() {
    glfwSwapBuffers(impl_->window);
    glfwPollEvents();
}

void Window::waitForEvents(double timeoutS) {
    glfwWaitEventsTimeout(timeoutS);
}

std::vector<Key> Window::takePressedKeys() {
    return std::exchange(impl_->pressedKeys, {});
}

GLFWwindow* Window::glfw() const {
    return impl_->window;
}

}  // namespace hazer::app
