#include "render/web_store.h"

#include "render/gl/inventory.h"

namespace hazer::render {

WebId WebStore::add(const IesWeb& web) {
    webs_.push_back(web);
    return static_cast<WebId>(webs_.size()) - 1;
}

GLuint WebStore::texture() {
    if (uploaded_ == webs_.size()) return texture_.id();
    texture_ = gl::makeTexture();
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.id());
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_R16F, kWebAzimuths, kWebThetas,
                 static_cast<GLsizei>(webs_.size()), 0, GL_RED, GL_FLOAT, nullptr);
    for (std::size_t i = 0; i < webs_.size(); ++i) {
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, static_cast<GLint>(i), kWebAzimuths, kWebThetas, 1,
                        GL_RED, GL_FLOAT, webs_[i].relative.data());
    }
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    uploaded_ = webs_.size();
    return texture_.id();
}

void WebStore::list(Resources& resources) const {
    gl::listTexture(resources, "webs", GL_TEXTURE_2D_ARRAY, texture_);
}

}  // namespace hazer::render
