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

    /// Draws over the bound framebuffer, where its depth is 1, from `picture`: a linearly filtered texture of
    /// the same size with brightness in alpha.
    void draw(GLuint picture);

    /// Adds what there is on the GPU.
    void list(Resources& resources) const { gl::listProgram(resources, program_); }

 private:
    gl::Program program_;
    gl::VertexArray noVertices_ = gl::makeVertexArray();
};

}  // namespace hazer::render
