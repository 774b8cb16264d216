// Meshes on the GPU.
#pragma once

#include <vector>

#include "render/gl/handle.h"
#include "render/mesh.h"
#include "render/resources.h"
#include "render/scene.h"

namespace hazer::render {

class MeshStore {
 public:
    MeshId add(const Mesh& mesh);

    /// The mesh as it was added, fetched back from the GPU.
    Mesh read(MeshId mesh) const;

    /// Draws with the program in use; vertex inputs 0 (position) and 1 (normal).
    void draw(MeshId mesh) const;

    /// Adds what there is on the GPU.
    void list(Resources& resources) const;

    /// Indexed by MeshId.
    const std::vector<MeshBounds>& bounds() const { return bounds_; }

 private:
    struct GpuMesh {
        gl::VertexArray vertexArray;
        gl::Buffer vertices;
        gl::Buffer indices;
        GLsizei indexCount = 0;
        std::size_t vertexCount = 0;
    };
    std::vector<GpuMesh> meshes_;
    std::vector<MeshBounds> bounds_;
};

}  // namespace hazer::render
