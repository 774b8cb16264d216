// Sum over all texels of a texture, without waiting for it.
#pragma once

#include <filesystem>
#include <vector>

#include "render/gl/handle.h"
#include "render/gl/program.h"
#include "render/resources.h"

namespace hazer::render {

/// Sizes of the textures that sum up one of `size` texels: each a 32nd along both edges, down to 1 x 1.
std::vector<glm::ivec2> texelSumSizes(glm::ivec2 size);

class TexelSum {
 public:
    explicit TexelSum(const std::filesystem::path& shaderFolder);

    /// For sources of `size` texels.
    void resize(glm::ivec2 size);

    /// Adds up the texels of `source`. Leaves another framebuffer and viewport bound.
    void draw(GLuint source);

    /// A single texel.
    GLuint texture() const { return steps_.back().texture.id(); }

    void list(Resources& resources) const;

 private:
    struct Step {
        gl::Texture texture;
        gl::Framebuffer target;
        glm::ivec2 size{0};
    };

    gl::LazyProgram program_;
    gl::VertexArray noVertices_ = gl::makeVertexArray();
    std::vector<Step> steps_;
};

}  // namespace hazer::render
