// Veiling glare: what a lens and an eye spread of very bright light. For the display only.
#pragma once

#include <filesystem>
#include <vector>

#include "render/gl/handle.h"
#include "render/gl/program.h"
#include "render/resources.h"

namespace hazer::render {

/// Width and height of the blurred pictures of a picture of this size, the finest first.
std::vector<glm::ivec2> bloomLevelSizes(int width, int height);

/// Nothing of it exists before the first draw().
class BloomPass {
 public:
    explicit BloomPass(const std::filesystem::path& shaderFolder);

    void resize(int width, int height);

    /// Blurs `radiance` (a texture of the size given to resize). The result has the same mean.
    void draw(GLuint radiance);

    /// Adds what there is on the GPU.
    void list(Resources& resources) const;

    /// Half the size of the picture.
    GLuint texture() const { return levels_.empty() ? 0 : levels_.front().texture.id(); }

 private:
    struct Level {
        gl::Texture texture;
        gl::Framebuffer framebuffer;
        int width = 0;
        int height = 0;
    };
    void allocate();
    void drawInto(const Level& target, GLuint source, int sourceWidth, int sourceHeight,
                  const gl::Program& program);

    gl::LazyProgram down_;
    gl::LazyProgram up_;
    gl::VertexArray noVertices_ = gl::makeVertexArray();
    std::vector<Level> levels_;
    int width_ = 0;
    int height_ = 0;
};

}  // namespace hazer::render
