#include "render/gl/pass_timer.h"

#include <string_view>

namespace hazer::render::gl {
namespace {

bool isSoftwareRasterizer() {
    const GLubyte* name = glGetString(GL_RENDERER);
    const std::string_view renderer = name ? reinterpret_cast<const char*>(name) : "";
    return renderer.find("llvmpipe") != std::string_view::npos ||
           renderer.find("softpipe") != std::string_view::npos;
}

}  // namespace

PassTimer::PassTimer() : software_(isSoftwareRasterizer()) {}

void PassTimer::beginFrame() {
    if (software_) {
        latest_ = std::exchange(running_, {});
        return;
    }
    current_ = (current_ + 1) % kFramesInFlight;
    collect(frames_[current_]);
    frames_[current_].names.clear();
}

void PassTimer::begin(const char* pass) {
    if (software_) {
        running_.emplace_back(pass, 0.0);
        started_ = std::chrono::steady_clock::now();
        return;
    }
    Frame& frame = frames_[current_];
    if (frame.queries.size() <= frame.names.size()) frame.queries.push_back(makeQuery());
    glBeginQuery(GL_TIME_ELAPSED, frame.queries[frame.names.size()].id());
    frame.names.emplace_back(pass);
}

void PassTimer::end() {
    if (!software_) {
        glEndQuery(GL_TIME_ELAPSED);
        return;
    }
    glFinish();
    running_.back().second =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - started_).count();
}

void PassTimer::collect(const Frame& frame) {
    if (frame.names.empty()) return;
    GLint ready = GL_FALSE;
    glGetQueryObjectiv(frame.queries[frame.names.size() - 1].id(), GL_QUERY_RESULT_AVAILABLE, &ready);
    if (ready != GL_TRUE) return;
    latest_ = timesOf(frame);
}

std::vector<std::pair<std::string, double>> PassTimer::timesOf(const Frame& frame) {
    std::vector<std::pair<std::string, double>> times;
    for (std::size_t i = 0; i < frame.names.size(); ++i) {
        GLuint64 nanoseconds = 0;
        glGetQueryObjectui64v(frame.queries[i].id(), GL_QUERY_RESULT, &nanoseconds);
        times.emplace_back(frame.names[i], static_cast<double>(nanoseconds) * 1e-6);
    }
    return times;
}

std::vector<std::pair<std::string, double>> PassTimer::last() const {
    return software_ ? running_ : timesOf(frames_[current_]);
}

}  // namespace hazer::render::gl
