// Smooths edges in the finished picture.
#pragma once

#include <filesystem>

#include "render/gl/handle.h"
#include "render/gl/inventory.h"
#include "render/gl/program.h"

namespace hazer::render {

class AntialiasPass {
 public:
    explicit AntialiasPass(const std::filesystem::path& shaderFolder);

    /// Writes the bound framebuffer from `display`, a linearly filtered texture of the same size.
    void draw(GLuint display, int width, int height);

    /// Adds what there is on the GPU.
    void list(Resources& resources) const { gl::listProgram(resources, program_); }

 private:
    gl::Program program_;
    gl::VertexArray noVertices_ = gl::makeVertexArray();
};

}  // namespace hazer::render
