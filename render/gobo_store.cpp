#include "render/gobo_store.h"

#include <array>

#include "render/gl/inventory.h"

namespace hazer::render {
namespace {

/// Every level comes from the picture itself, so that the GPU and the CPU look at the same texels.
void uploadLevel(const std::vector<std::shared_ptr<const GoboPicture>>& pictures, int level) {
    const int size = kGoboSize >> level;
    glTexImage3D(GL_TEXTURE_2D_ARRAY, level, GL_RGBA8, size, size, static_cast<GLsizei>(pictures.size()), 0,
                 GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, level, 0, 0, static_cast<GLint>(i), size, size, 1, GL_RGBA,
                        GL_UNSIGNED_BYTE, pictures[i]->levels[static_cast<std::size_t>(level)].data());
    }
}

}  // namespace

GoboId GoboStore::add(const std::uint8_t* rgba, int width, int height) {
    pictures_.push_back(std::make_shared<const GoboPicture>(makeGoboPicture(rgba, width, height)));
    return static_cast<GoboId>(pictures_.size()) - 1;
}

GLuint GoboStore::texture() {
    if (uploaded_ == pictures_.size()) return texture_.id();
    // The holder around a gobo is black, however blurred.
    static constexpr std::array<float, 4> kBlack{0.0f, 0.0f, 0.0f, 1.0f};
    texture_ = gl::makeTexture();
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.id());
    for (int level = 0; level < kGoboLevels; ++level) uploadLevel(pictures_, level);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, kGoboLevels - 1);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    glTexParameterfv(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BORDER_COLOR, kBlack.data());
    uploaded_ = pictures_.size();
    return texture_.id();
}

void GoboStore::list(Resources& resources) const {
    gl::listTexture(resources, "gobos", GL_TEXTURE_2D_ARRAY, texture_);
}

}  // namespace hazer::render
