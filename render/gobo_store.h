// Gobo pictures on the GPU: one texture array of linear transmission.
#pragma once

#include <cstdint>
#include <vector>

#include "render/gl/handle.h"
#include "render/resources.h"
#include "render/scene.h"

namespace hazer::render {

/// What one gobo lets through: `kGoboSize`^2 RGBA texels, linear, row 0 on top, black outside the inscribed
/// circle.
std::vector<std::uint8_t> goboTransmission(const std::uint8_t* rgba, int width, int height);

inline constexpr int kGoboSize = 512;

class GoboStore {
 public:
    /// See Renderer::addGobo.
    GoboId add(const std::uint8_t* rgba, int width, int height);

    /// What goboTransmission() made of a gobo.
    const std::vector<std::uint8_t>& texels(GoboId gobo) const {
        return layers_[static_cast<std::size_t>(gobo)];
    }

    /// A GL_TEXTURE_2D_ARRAY with mip levels; 0 while there are no gobos.
    GLuint texture();

    /// Adds what there is on the GPU.
    void list(Resources& resources) const;

 private:
    std::vector<std::vector<std::uint8_t>> layers_;
    gl::Texture texture_;
    std::size_t uploaded_ = 0;
};

}  // namespace hazer::render
