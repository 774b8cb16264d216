// Smooths edges in the finished picture.
#pragma once

#include <filesystem>

#include "render/gl/handle.h"
#include "render/gl/program.h"

namespace hazer::render {

class AntialiasPass {
 public:
    explicit AntialiasPass(const std::filesystem::path& shaderFolder);

    /// Writes the bound framebuffer from `display`, a linearly filtered texture of the same size.
    void draw(GLuint display, int width, int height);

 private:
    gl::Program program_;
    gl::VertexArray noVertices_ = gl::makeVertexArray();
};

}  // namespace hazer::render
