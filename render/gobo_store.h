// Gobo pictures on the GPU: one texture array of linear transmission.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "render/gl/handle.h"
#include "render/gobo_picture.h"
#include "render/resources.h"
#include "render/scene.h"

namespace hazer::render {

class GoboStore {
 public:
    /// See Renderer::addGobo.
    GoboId add(const std::uint8_t* rgba, int width, int height);

    /// What a gobo lets through: the sharp level of its picture.
    const std::vector<std::uint8_t>& texels(GoboId gobo) const {
        return pictures_[static_cast<std::size_t>(gobo)]->levels[0];
    }

    /// A GL_TEXTURE_2D_ARRAY with mip levels; 0 while there are no gobos.
    GLuint texture();

    /// Adds what there is on the GPU.
    void list(Resources& resources) const;

 private:
    std::vector<std::shared_ptr<const GoboPicture>> pictures_;
    gl::Texture texture_;
    std::size_t uploaded_ = 0;
};

}  // namespace hazer::render
