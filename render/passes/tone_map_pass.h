// The last pass: radiance to display colours.
#pragma once

#include <filesystem>

#include "render/gl/handle.h"
#include "render/gl/program.h"
#include "render/resources.h"

namespace hazer::render {

class ToneMapPass {
 public:
    explicit ToneMapPass(const std::filesystem::path& shaderFolder);

    /// Writes the bound framebuffer, which has the size of `radiance`. bloom 0: none.
    void draw(GLuint radiance, GLuint bloom, int width, int height, float exposureEv100);

    /// Adds what there is on the GPU.
    void list(Resources& resources) const;

 private:
    gl::LazyProgram plain_;
    gl::LazyProgram withBloom_;
    gl::VertexArray noVertices_ = gl::makeVertexArray();
};

}  // namespace hazer::render
