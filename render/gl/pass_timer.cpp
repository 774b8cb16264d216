#include "render/gl/pass_timer.h"

namespace hazer::render::gl {

void PassTimer::beginFrame() {
    current_ = (current_ + 1) % kFramesInFlight;
    collect(frames_[current_]);
    frames_[current_].names.clear();
}

void PassTimer::begin(const char* pass) {
    Frame& frame = frames_[current_];
    if (frame.queries.size() <= frame.names.size()) frame.queries.push_back(makeQuery());
    glBeginQuery(GL_TIME_ELAPSED, frame.queries[frame.names.size()].id());
    frame.names.emplace_back(pass);
}

void PassTimer::end() {
    glEndQuery(GL_TIME_ELAPSED);
}

void PassTimer::collect(const Frame& frame) {
    if (frame.names.empty()) return;
    GLint ready = GL_FALSE;
    glGetQueryObjectiv(frame.queries[frame.names.size() - 1].id(), GL_QUERY_RESULT_AVAILABLE, &ready);
    if (ready != GL_TRUE) return;
    latest_.clear();
    for (std::size_t i = 0; i < frame.names.size(); ++i) {
        GLuint64 nanoseconds = 0;
        glGetQueryObjectui64v(frame.queries[i].id(), GL_QUERY_RESULT, &nanoseconds);
        latest_.emplace_back(frame.names[i], static_cast<double>(nanoseconds) * 1e-6);
    }
}

}  // namespace hazer::render::gl
