#include "render/gl/headless_context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include "render/error.h"

namespace hazer::render::gl {

struct HeadlessContext::Impl {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    ~Impl() {
        if (display == EGL_NO_DISPLAY) return;
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
        eglTerminate(display);
    }
};

namespace {

/// EGL calls its errors by number; people look them up in hexadecimal.
[[noreturn]] void fail(const char* step) {
    throw NoGlError(
        fmt::format("No OpenGL 4.1 without a window: {} failed (EGL error 0x{:04x}); install Mesa's EGL "
                    "(packages libegl1 and libgl1-mesa-dri) or a driver with the surfaceless platform",
                    step, static_cast<unsigned>(eglGetError())));
}

/// The surfaceless platform where there is one, else whatever display the system calls its default.
EGLDisplay openDisplay() {
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
        EGLDisplay display =
            eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (display != EGL_NO_DISPLAY) return display;
    }
    return eglGetDisplay(EGL_DEFAULT_DISPLAY);
}

}  // namespace

HeadlessContext::HeadlessContext() : impl_(std::make_unique<Impl>()) {
    EGLDisplay display = openDisplay();
    if (display == EGL_NO_DISPLAY) fail("eglGetPlatformDisplay");
    if (!eglInitialize(display, nullptr, nullptr)) fail("eglInitialize");
    impl_->display = display;
    if (!eglBindAPI(EGL_OPENGL_API)) fail("eglBindAPI");
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 4,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 1,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_CONTEXT_OPENGL_DEBUG,
                                 EGL_TRUE,
                                 EGL_NONE};
    impl_->context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (impl_->context == EGL_NO_CONTEXT) fail("eglCreateContext");
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, impl_->context)) fail("eglMakeCurrent");
}

HeadlessContext::~HeadlessContext() = default;

std::string describeContext() {
    const GLubyte* renderer = glGetString(GL_RENDERER);
    const int version = epoxy_gl_version();
    return fmt::format("{}, OpenGL {}.{}",
                       renderer ? reinterpret_cast<const char*>(renderer) : "unknown renderer", version / 10,
                       version % 10);
}

}  // namespace hazer::render::gl
