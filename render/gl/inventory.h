// Lists what there is on the GPU, as OpenGL itself has it.
#pragma once

#include "render/gl/handle.h"
#include "render/gl/program.h"
#include "render/resources.h"

namespace hazer::render::gl {

// Each adds one thing to the list, or nothing if it does not exist yet. Sizes are asked of OpenGL, not of
// whoever made the thing.

/// `target` is what the texture is bound to: GL_TEXTURE_2D, GL_TEXTURE_2D_ARRAY or GL_TEXTURE_3D. It is left
/// unbound.
void listTexture(Resources& resources, const char* name, GLenum target, const Texture& texture);
/// A texture that looks into `buffer`, one row of texels of `bytesPerTexel` bytes; bytes are the buffer's.
void listBufferTexture(Resources& resources, const char* name, const Buffer& buffer, int bytesPerTexel);
void listBuffer(Resources& resources, const char* name, const Buffer& buffer);
void listProgram(Resources& resources, const Program& program);
void listProgram(Resources& resources, const LazyProgram& program);

}  // namespace hazer::render::gl
