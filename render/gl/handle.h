// Owns one OpenGL name.
#pragma once

#include <epoxy/gl.h>

#include <utility>

namespace hazer::render::gl {

/// Move-only owner of a GL name; a default-constructed handle owns nothing. Destroy it on the thread of its
/// context.
template <auto Delete>
class Handle {
 public:
    Handle() = default;
    explicit Handle(GLuint id) noexcept : id_(id) {}
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    ~Handle() {
        if (id_ != 0) Delete(id_);
    }
    GLuint id() const noexcept { return id_; }

 private:
    GLuint id_ = 0;
};

inline void deleteTexture(GLuint id) {
    glDeleteTextures(1, &id);
}
inline void deleteBuffer(GLuint id) {
    glDeleteBuffers(1, &id);
}
inline void deleteVertexArray(GLuint id) {
    glDeleteVertexArrays(1, &id);
}
inline void deleteFramebuffer(GLuint id) {
    glDeleteFramebuffers(1, &id);
}
inline void deleteQuery(GLuint id) {
    glDeleteQueries(1, &id);
}
inline void deleteShader(GLuint id) {
    glDeleteShader(id);
}
inline void deleteProgram(GLuint id) {
    glDeleteProgram(id);
}

using Texture = Handle<deleteTexture>;
using Buffer = Handle<deleteBuffer>;
using VertexArray = Handle<deleteVertexArray>;
using Framebuffer = Handle<deleteFramebuffer>;
using Query = Handle<deleteQuery>;
using Shader = Handle<deleteShader>;
using ProgramHandle = Handle<deleteProgram>;

inline Texture makeTexture() {
    GLuint id = 0;
    glGenTextures(1, &id);
    return Texture(id);
}
inline Buffer makeBuffer() {
    GLuint id = 0;
    glGenBuffers(1, &id);
    return Buffer(id);
}
inline VertexArray makeVertexArray() {
    GLuint id = 0;
    glGenVertexArrays(1, &id);
    return VertexArray(id);
}
inline Framebuffer makeFramebuffer() {
    GLuint id = 0;
    glGenFramebuffers(1, &id);
    return Framebuffer(id);
}
inline Query makeQuery() {
    GLuint id = 0;
    glGenQueries(1, &id);
    return Query(id);
}

}  // namespace hazer::render::gl
