// Radiance to display colours.
#pragma once

#include <filesystem>

#include "render/gl/handle.h"
#include "render/gl/program.h"
#include "render/passes/display_grid.h"
#include "render/resources.h"

namespace hazer::render {

class ToneMapPass {
 public:
    explicit ToneMapPass(const std::filesystem::path& shaderFolder);

    /// Writes colour 0 (alpha: brightness) and colour 1 (the same, opaque) of the bound framebuffer, which
    /// has the size of `radiance` and the grid's mask as its depth.
    void draw(GLuint radiance, const DisplayGrid& grid, bool withBloom, float exposure);

    /// Adds what there is on the GPU.
    void list(Resources& resources) const;

 private:
    gl::LazyProgram plain_;
    gl::LazyProgram withBloom_;
    gl::VertexArray noVertices_ = gl::makeVertexArray();
};

}  // namespace hazer::render
