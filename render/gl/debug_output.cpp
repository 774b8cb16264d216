#include "render/gl/debug_output.h"

#include <epoxy/gl.h>
#include <spdlog/spdlog.h>

#include <atomic>

namespace hazer::render::gl {
namespace {

std::atomic<int> errorCount{0};

void GLAPIENTRY onMessage(GLenum /*source*/, GLenum type, GLuint /*id*/, GLenum severity, GLsizei /*length*/,
                          const GLchar* message, const void* /*user*/) {
    if (type == GL_DEBUG_TYPE_ERROR) {
        ++errorCount;
        spdlog::error("OpenGL: {}", message);
    } else if (severity == GL_DEBUG_SEVERITY_HIGH) {
        spdlog::warn("OpenGL: {}", message);
    }
}

bool hasDebug() {
    return epoxy_has_gl_extension("GL_KHR_debug");
}

}  // namespace

void enableDebugOutput() {
    if (!hasDebug()) return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(onMessage, nullptr);
}

int debugErrorCount() {
    return errorCount;
}

DebugGroup::DebugGroup(const char* name) {
    if (hasDebug()) glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name);
}

DebugGroup::~DebugGroup() {
    if (hasDebug()) glPopDebugGroup();
}

}  // namespace hazer::render::gl
