#include "app/window_thumbnails.h"

#include <cstdint>

namespace hazer::app {
namespace {

render::gl::Texture upload(const fixtures::WheelImage& image) {
    render::gl::Texture texture = render::gl::makeTexture();
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 image.rgba.data());
    // Shown at about a tenth of its size: without the smaller levels, fine gobos would flicker.
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return texture;
}

}  // namespace

ImTextureID WindowThumbnails::textureOf(const std::shared_ptr<const fixtures::WheelImage>& image) {
    render::gl::Texture& texture = textures_[image];
    if (texture.id() == 0) texture = upload(*image);
    // ImGui's OpenGL backend takes the GL name in place of a pointer.
    return reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(texture.id()));
}

}  // namespace hazer::app
