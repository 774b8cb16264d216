#include "render/gl/inventory.h"

#include <algorithm>
#include <array>
#include <bit>

namespace hazer::render::gl {
namespace {

constexpr std::array<GLenum, 6> kComponentSizes{GL_TEXTURE_RED_SIZE,   GL_TEXTURE_GREEN_SIZE,
                                                GL_TEXTURE_BLUE_SIZE,  GL_TEXTURE_ALPHA_SIZE,
                                                GL_TEXTURE_DEPTH_SIZE, GL_TEXTURE_STENCIL_SIZE};

GLint levelParameter(GLenum target, int level, GLenum parameter) {
    GLint value = 0;
    glGetTexLevelParameteriv(target, level, parameter, &value);
    return value;
}

std::size_t levelBytes(GLenum target, int level) {
    std::size_t bits = 0;
    for (const GLenum component : kComponentSizes) {
        bits += static_cast<std::size_t>(levelParameter(target, level, component));
    }
    std::size_t texels = 1;
    for (const GLenum edge : {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_DEPTH}) {
        texels *= static_cast<std::size_t>(levelParameter(target, level, edge));
    }
    return texels * bits / 8;
}

/// Bytes; 0 if there is none.
std::size_t sizeOf(const Buffer& buffer) {
    if (buffer.id() == 0) return 0;
    GLint64 bytes = 0;
    // The copy target, so that no vertex array's index buffer is replaced.
    glBindBuffer(GL_COPY_READ_BUFFER, buffer.id());
    glGetBufferParameteri64v(GL_COPY_READ_BUFFER, GL_BUFFER_SIZE, &bytes);
    return static_cast<std::size_t>(bytes);
}

}  // namespace

void listTexture(Resources& resources, const char* name, GLenum target, const Texture& texture) {
    if (texture.id() == 0) return;
    glBindTexture(target, texture.id());
    TextureUse use{name};
    use.width = levelParameter(target, 0, GL_TEXTURE_WIDTH);
    use.height = levelParameter(target, 0, GL_TEXTURE_HEIGHT);
    use.layers = levelParameter(target, 0, GL_TEXTURE_DEPTH);
    // No texture has more levels than it takes to come down to one texel.
    const int most = std::bit_width(static_cast<unsigned>(std::max(use.width, use.height)));
    use.levels = 0;
    while (use.levels < most && levelParameter(target, use.levels, GL_TEXTURE_WIDTH) > 0) {
        use.bytes += levelBytes(target, use.levels);
        ++use.levels;
    }
    glBindTexture(target, 0);
    resources.textures.push_back(use);
}

void listBufferTexture(Resources& resources, const char* name, const Buffer& buffer, int bytesPerTexel) {
    const std::size_t bytes = sizeOf(buffer);
    if (bytes == 0) return;
    const int texels = static_cast<int>(bytes) / bytesPerTexel;
    resources.textures.push_back({name, texels, 1, 1, 1, bytes});
}

void listBuffer(Resources& resources, const char* name, const Buffer& buffer) {
    const std::size_t bytes = sizeOf(buffer);
    if (bytes > 0) resources.buffers.push_back({name, bytes});
}

void listProgram(Resources& resources, const Program& program) {
    resources.shaders.push_back(program.name());
}

void listProgram(Resources& resources, const LazyProgram& program) {
    if (program.compiled()) listProgram(resources, *program.compiled());
}

}  // namespace hazer::render::gl
