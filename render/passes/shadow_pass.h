// Depth as each shadowed lamp sees it: one texture with a tile for each map.
#pragma once

#include <filesystem>
#include <vector>

#include "render/gl/handle.h"
#include "render/gl/program.h"
#include "render/mesh_store.h"
#include "render/resources.h"
#include "render/scene_plan.h"
#include "render/shadow_atlas.h"
#include "render/shadow_projection.h"

namespace hazer::render {

/// What the shaders look shadows up in; 0 before the first map.
struct ShadowTextures {
    GLuint atlas = 0;  ///< A GL_TEXTURE_2D of depths: near / axial distance, 0 where nothing casts.
    GLuint faces = 0;  ///< A GL_TEXTURE_BUFFER of face records, map after map, faceRecordCount of each.
};

class ShadowPass {
 public:
    explicit ShadowPass(const std::filesystem::path& shaderFolder);

    /// Draws the plan's maps. A lamp that stands still before things that stand still keeps its map.
    void draw(const Scene& scene, const ScenePlan& plan, const MeshStore& meshes);

    /// Adds what there is on the GPU.
    void list(Resources& resources) const;

    ShadowTextures textures() const { return {atlas_.id(), faces_.id()}; }

    /// Maps that the last frame had to draw.
    int redrawn() const { return redrawn_; }

    /// Texels along both edges of the atlas; 0 before the first map.
    int atlasEdge() const { return allocatedEdge_; }

 private:
    void allocate(int edge);
    void drawTile(const ShadowTile& tile, const ShadowContent& content, const gl::Program& program,
                  const MeshStore& meshes);
    void uploadFaces(const std::vector<ShadowFaceRecord>& records);

    gl::LazyProgram program_;
    ShadowAtlas tiles_;
    gl::Texture atlas_, faces_;
    gl::Buffer faceBuffer_;
    gl::Framebuffer framebuffer_;
    int allocatedEdge_ = 0;
    int redrawn_ = 0;
};

}  // namespace hazer::render
