// Draws the bodies into buffers of normal, distance and material; lamps light them later, each only where its
// cone is seen.
#pragma once

#include <filesystem>

#include "render/gl/handle.h"
#include "render/gl/program.h"
#include "render/mesh_store.h"
#include "render/resources.h"
#include "render/scene.h"

namespace hazer::render {

class SurfacePass {
 public:
    explicit SurfacePass(const std::filesystem::path& shaderFolder);

    /// Makes targets for pictures of this size. Without bodies one texel of sky stands for the whole geometry
    /// buffer, there is no other target, and draw() must not be called.
    void resize(int width, int height, bool hasBodies);
    void draw(const Scene& scene, const Camera& camera, const MeshStore& meshes);

    /// Adds what there is on the GPU.
    void list(Resources& resources) const;

    GLuint geometry() const { return geometry_.id(); }
    GLuint material() const { return material_.id(); }
    GLuint depth() const { return depth_.id(); }

 private:
    gl::LazyProgram program_;
    gl::Texture geometry_, material_, depth_;
    gl::Framebuffer framebuffer_;
    double aspect_ = 1.0;
};

}  // namespace hazer::render
