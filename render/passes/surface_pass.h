// Begins the picture: the background and the bodies in the ambient light. Also leaves buffers of distance,
// normal and shininess, and a table of materials; lamps light the bodies later, each only where its cone is
// seen.
#pragma once

#include <filesystem>

#include "render/gl/handle.h"
#include "render/gl/program.h"
#include "render/mesh_store.h"
#include "render/resources.h"
#include "render/scene.h"

namespace hazer::render {

/// Texels of the table of materials for so many bodies: a texel each, in rows of MATERIAL_ROW of
/// shaders/include/surface.glsl.
glm::ivec2 materialTableSize(std::size_t bodies);

class SurfacePass {
 public:
    explicit SurfacePass(const std::filesystem::path& shaderFolder);

    /// Makes targets for pictures of this size; `radiance` is a texture of it, which every draw begins anew.
    /// Without bodies one texel of sky stands for all distances, there is no other target, and draw() must
    /// not be called.
    void resize(int width, int height, GLuint radiance, bool hasBodies);
    /// Bodies are seen through haze of this extinction.
    void draw(const Scene& scene, float extinctionPerM, const Camera& camera, const MeshStore& meshes);

    /// Adds what there is on the GPU.
    void list(Resources& resources) const;

    // What shaders/include/surface.glsl describes.
    GLuint distance() const { return distance_.id(); }
    GLuint shape() const { return shape_.id(); }
    GLuint materials() const { return materials_.id(); }
    GLuint depth() const { return depth_.id(); }

 private:
    void begin(const Scene& scene);
    void uploadMaterials(const Scene& scene);
    void drawInstance(std::size_t index, const Camera& camera, const Scene& scene, const MeshStore& meshes);

    gl::LazyProgram program_;
    gl::Texture distance_, shape_, depth_;
    gl::Texture materials_;
    gl::Framebuffer framebuffer_;
    double aspect_ = 1.0;
};

}  // namespace hazer::render
