// Begins the picture of a scene with bodies: background, and surfaces in the ambient light.
#pragma once

#include <filesystem>

#include "render/gl/inventory.h"
#include "render/gl/program.h"
#include "render/passes/surface_pass.h"
#include "render/scene.h"

namespace hazer::render {

class AmbientPass {
 public:
    explicit AmbientPass(const std::filesystem::path& shaderFolder);

    /// Writes every pixel of the bound framebuffer.
    void draw(const Scene& scene, const SurfacePass& surfaces);

    /// Adds what there is on the GPU.
    void list(Resources& resources) const { gl::listProgram(resources, program_); }

 private:
    gl::LazyProgram program_;
    gl::VertexArray noVertices_ = gl::makeVertexArray();
};

}  // namespace hazer::render
