// Depth as each shadowed lamp sees it: an array of maps, one layer a lamp.
#pragma once

#include <filesystem>
#include <utility>
#include <vector>

#include "render/gl/handle.h"
#include "render/gl/program.h"
#include "render/mesh_store.h"
#include "render/resources.h"
#include "render/scene_plan.h"

namespace hazer::render {

class ShadowPass {
 public:
    explicit ShadowPass(const std::filesystem::path& shaderFolder);

    /// Draws the plan's maps. A lamp that stands still before things that stand still keeps last frame's map.
    void draw(const Scene& scene, const ScenePlan& plan, const MeshStore& meshes);

    /// Adds what there is on the GPU.
    void list(Resources& resources) const;

    /// A GL_TEXTURE_2D_ARRAY of depths with comparison, or 0 before the first map.
    GLuint texture() const { return maps_.id(); }

 private:
    /// All that a map's content depends on.
    struct Content {
        glm::dmat4 clipFromWorld{0.0};
        std::vector<std::pair<MeshId, glm::dmat4>> casters;
        bool operator==(const Content&) const = default;
    };
    void allocate(int size, int layers);
    void drawMap(int layer, const Content& content, const gl::Program& program, const MeshStore& meshes);

    gl::LazyProgram program_;
    gl::Texture maps_;
    gl::Framebuffer framebuffer_;
    std::vector<Content> contents_;
    int size_ = 0;
};

}  // namespace hazer::render
