// Bodies that stand still under light that stands still: their picture is kept instead of being drawn anew.
#pragma once

#include <vector>

#include "render/gl/handle.h"
#include "render/resources.h"
#include "render/scene_plan.h"

namespace hazer::render {

/// All that light on surfaces depends on.
struct SurfaceView {
    std::vector<MeshInstance> instances;
    std::vector<Beam> beams;
    Camera camera;
    Ambient ambient;
    Color backgroundCdPerM2{0.0f};
    float extinctionPerM = 0.0f;
    int width = 0;
    int height = 0;
    bool shadows = true;
    bool gobos = true;

    bool operator==(const SurfaceView&) const = default;
};

SurfaceView surfaceView(const Scene& scene, const Camera& camera, const Settings& settings,
                        const ScenePlan& plan);

/// Keeps the radiance of lit surfaces once two frames in a row show the same. What moves costs a comparison.
class StillSurfaces {
 public:
    /// To be told of each frame before its surfaces are drawn.
    void beginFrame(SurfaceView view);

    /// Is the frame's picture at hand?
    bool isKept() const { return state_ == State::kKept; }

    /// Brings the kept picture into a framebuffer, and binds it.
    void restore(GLuint framebuffer) const;

    /// Takes the picture from a framebuffer, which stays bound, if it was the same in the frame before.
    void keep(GLuint framebuffer);

    void list(Resources& resources) const;

 private:
    enum class State { kMoving, kSame, kKept };

    void blit(GLuint from, GLuint to) const;

    SurfaceView view_;
    State state_ = State::kMoving;
    glm::ivec2 size_{0};  ///< Of the picture.
    gl::Texture picture_;
    gl::Framebuffer target_;
};

}  // namespace hazer::render
