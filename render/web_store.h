// Photometric webs on the GPU: one texture array of relative intensity.
#pragma once

#include <span>
#include <vector>

#include "render/gl/handle.h"
#include "render/ies_web.h"
#include "render/resources.h"
#include "render/scene.h"

namespace hazer::render {

class WebStore {
 public:
    /// See Renderer::addWeb.
    WebId add(const IesWeb& web);

    /// WebId i is webs()[i].
    std::span<const IesWeb> webs() const { return webs_; }

    /// A GL_TEXTURE_2D_ARRAY, one layer a web, in 16-bit floats relative to the peak; 0 while there are none.
    GLuint texture();

    /// Adds what there is on the GPU.
    void list(Resources& resources) const;

 private:
    std::vector<IesWeb> webs_;
    gl::Texture texture_;
    std::size_t uploaded_ = 0;
};

}  // namespace hazer::render
