#include "render/gl/texture.h"

#include <fmt/format.h>

#include <vector>

#include "render/error.h"

namespace hazer::render::gl {
namespace {

/// Format and type that go with an internal format when there is nothing to upload; GL wants a legal pair all
/// the same.
std::pair<GLenum, GLenum> uploadFormat(GLenum internalFormat) {
    if (internalFormat == GL_DEPTH_COMPONENT32F || internalFormat == GL_DEPTH_COMPONENT16)
        return {GL_DEPTH_COMPONENT, GL_FLOAT};
    return {GL_RGBA, GL_FLOAT};
}

}  // namespace

Texture makeTexture2d(GLenum internalFormat, int width, int height, GLenum filter) {
    Texture texture = makeTexture();
    glBindTexture(GL_TEXTURE_2D, texture.id());
    const auto [format, type] = uploadFormat(internalFormat);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internalFormat), width, height, 0, format, type,
                 nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(filter));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(filter));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    return texture;
}

Framebuffer makeFramebufferFor(std::initializer_list<GLuint> colors, GLuint depth) {
    Framebuffer framebuffer = makeFramebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    std::vector<GLenum> attachments;
    for (const GLuint color : colors) {
        const GLenum attachment = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(attachments.size());
        glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, color, 0);
        attachments.push_back(attachment);
    }
    glDrawBuffers(static_cast<GLsizei>(attachments.size()), attachments.data());
    if (depth != 0) glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        throw RenderError(fmt::format(
            "The graphics driver refuses a render target (status 0x{:04x}); try a smaller picture", status));
    }
    return framebuffer;
}

void bindTexture(int unit, GLenum target, GLuint texture) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(target, texture);
}

}  // namespace hazer::render::gl
