// Textures and the framebuffers that draw into them.
#pragma once

#include <initializer_list>

#include "render/gl/handle.h"

namespace hazer::render::gl {

/// An empty 2-D texture, clamped to its edge. `filter` is GL_NEAREST or GL_LINEAR.
Texture makeTexture2d(GLenum internalFormat, int width, int height, GLenum filter);

/// A framebuffer that draws into `colors` (attachments 0, 1, ...) and, unless 0, `depth`. Throws RenderError
/// if the driver refuses it.
Framebuffer makeFramebufferFor(std::initializer_list<GLuint> colors, GLuint depth = 0);

/// Binds a texture to a unit for sampling.
void bindTexture(int unit, GLenum target, GLuint texture);

}  // namespace hazer::render::gl
