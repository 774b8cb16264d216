// Veiling glare: what a lens and an eye spread of very bright light. For the display only.
#pragma once

#include <filesystem>
#include <vector>

#include "render/gl/handle.h"
#include "render/gl/program.h"
#include "render/resources.h"

namespace hazer::render {

/// A clean camera lens scatters a few percent of what falls on it. What stays within two pixels is not drawn.
inline constexpr float kBloomShare = 0.02f;

/// Sizes of the levels for a picture of so many blocks, largest first.
std::vector<glm::ivec2> bloomLevelSizes(glm::ivec2 blocks);

class BloomPass {
 public:
    explicit BloomPass(const std::filesystem::path& shaderFolder);

    /// For a picture of so many blocks.
    void resize(glm::ivec2 blocks);

    /// Blurs the means of blocks, a linearly filtered texture of the size given to resize.
    void draw(GLuint means);

    /// Light of the same mean, blurred, at half the size of the blocks. Together with the blocks themselves,
    /// half and half, it is the bloom.
    GLuint texture() const { return levels_.empty() ? 0 : levels_.front().texture.id(); }
    glm::ivec2 size() const { return levels_.front().size; }

    /// Adds what there is on the GPU.
    void list(Resources& resources) const;

 private:
    struct Level {
        gl::Texture texture;
        gl::Framebuffer framebuffer;
        glm::ivec2 size{0};
    };
    void allocate();
    static void drawInto(const Level& target, GLuint source, glm::ivec2 sourceSize,
                         const gl::Program& program);

    gl::LazyProgram down_;
    gl::LazyProgram up_;
    gl::VertexArray noVertices_ = gl::makeVertexArray();
    std::vector<Level> levels_;
    glm::ivec2 blocks_{0};
};

}  // namespace hazer::render
