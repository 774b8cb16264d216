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

/// A fresh name from one of the glGen functions.
template <typename Owner, typename Generate>
Owner make(Generate generate) {
    GLuint id = 0;
    generate(1, &id);
    return Owner(id);
}

inline Texture makeTexture() {
    return make<Texture>(glGenTextures);
}
inline Buffer makeBuffer() {
    return make<Buffer>(glGenBuffers);
}
inline VertexArray makeVertexArray() {
    return make<VertexArray>(glGenVertexArrays);
}
inline Framebuffer makeFramebuffer() {
    return make<Framebuffer>(glGenFramebuffers);
}
inline Query makeQuery() {
    return make<Query>(glGenQueries);
}

}  // namespace hazer::render::gl
