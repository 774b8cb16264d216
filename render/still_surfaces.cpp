#include "render/still_surfaces.h"

#include <utility>

#include "render/gl/inventory.h"
#include "render/gl/texture.h"

namespace hazer::render {

SurfaceView surfaceView(const Scene& scene, const Camera& camera, const Settings& settings,
                        const ScenePlan& plan) {
    return {
        scene.instances,          scene.beams,    camera,          scene.ambient,    scene.backgroundCdPerM2,
        plan.haze.extinctionPerM, settings.width, settings.height, settings.shadows, settings.gobos};
}

void StillSurfaces::beginFrame(SurfaceView view) {
    if (view == view_) {
        if (state_ == State::kMoving) state_ = State::kSame;
        return;
    }
    view_ = std::move(view);
    state_ = State::kMoving;
}

void StillSurfaces::blit(GLuint from, GLuint to) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    glBlitFramebuffer(0, 0, size_.x, size_.y, 0, 0, size_.x, size_.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void StillSurfaces::restore(GLuint framebuffer) const {
    blit(target_.id(), framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

void StillSurfaces::keep(GLuint framebuffer) {
    if (state_ != State::kSame) return;
    const glm::ivec2 size(view_.width, view_.height);
    if (size != size_) {
        size_ = size;
        picture_ = gl::makeTexture2d(GL_RGBA32F, size.x, size.y, GL_NEAREST);
        target_ = gl::makeFramebufferFor({picture_.id()});
    }
    blit(framebuffer, target_.id());
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    state_ = State::kKept;
}

void StillSurfaces::list(Resources& resources) const {
    gl::listTexture(resources, "still surfaces", GL_TEXTURE_2D, picture_);
}

}  // namespace hazer::render
