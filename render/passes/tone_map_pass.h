// The last pass: radiance to display colours.
#pragma once

#include <filesystem>

#include "render/gl/handle.h"
#include "render/gl/program.h"

namespace hazer::render {

class ToneMapPass {
 public:
    explicit ToneMapPass(const std::filesystem::path& shaderFolder);

    /// Writes the bound framebuffer, which has the size of `radiance`. bloom 0: none.
    void draw(GLuint radiance, GLuint bloom, int width, int height, float exposureEv100);

 private:
    gl::Program plain_;
    gl::Program withBloom_;
    gl::VertexArray noVertices_ = gl::makeVertexArray();
};

}  // namespace hazer::render
