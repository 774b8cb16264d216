// Pictures of wheel slots, small, for the panels.
#pragma once

#include <imgui.h>

#include <map>
#include <memory>

#include "fixtures/fixture_type.h"
#include "render/gl/handle.h"

namespace hazer::app {

/// Gives each picture to OpenGL once, when it is first shown. Destroy it on the thread of its context.
class WindowThumbnails {
 public:
    /// `image` must not be null.
    ImTextureID textureOf(const std::shared_ptr<const fixtures::WheelImage>& image);

 private:
    std::map<std::shared_ptr<const fixtures::WheelImage>, render::gl::Texture> textures_;
};

}  // namespace hazer::app
