#include "render/passes/bloom_pass.h"

#include "render/gl/inventory.h"
#include "render/gl/texture.h"

namespace hazer::render {
namespace {
constexpr int kLevels = 4;
}

std::vector<glm::ivec2> bloomLevelSizes(glm::ivec2 blocks) {
    std::vector<glm::ivec2> sizes;
    for (int i = 0; i < kLevels; ++i) {
        blocks = (blocks + 1) / 2;
        sizes.push_back(blocks);
    }
    return sizes;
}

BloomPass::BloomPass(const std::filesystem::path& shaderFolder)
    : down_(shaderFolder, "fullscreen.vert", "bloom_down.frag"),
      up_(shaderFolder, "fullscreen.vert", "bloom_up.frag") {}

void BloomPass::resize(glm::ivec2 blocks) {
    blocks_ = blocks;
    levels_.clear();
}

void BloomPass::allocate() {
    for (const glm::ivec2& size : bloomLevelSizes(blocks_)) {
        Level level{gl::makeTexture2d(GL_RGBA32F, size.x, size.y, GL_LINEAR), {}, size};
        level.framebuffer = gl::makeFramebufferFor({level.texture.id()});
        levels_.push_back(std::move(level));
    }
}

void BloomPass::drawInto(const Level& target, GLuint source, glm::ivec2 sourceSize,
                         const gl::Program& program) {
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
    glViewport(0, 0, target.size.x, target.size.y);
    gl::bindTexture(0, GL_TEXTURE_2D, source);
    program.set("source", 0);
    program.set("sourceTexel", 1.0f / glm::vec2(sourceSize));
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void BloomPass::draw(GLuint means) {
    if (levels_.empty()) allocate();
    const gl::Program& down = down_.get();
    const gl::Program& up = up_.get();
    glBindVertexArray(noVertices_.id());
    down.use();
    drawInto(levels_.front(), means, blocks_, down);
    for (std::size_t i = 1; i < levels_.size(); ++i) {
        drawInto(levels_[i], levels_[i - 1].texture.id(), levels_[i - 1].size, down);
    }
    // Each level becomes an even mix of itself and everything coarser, so that the weights sum to 1.
    glEnable(GL_BLEND);
    glBlendColor(0.0f, 0.0f, 0.0f, 0.5f);
    glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
    up.use();
    for (std::size_t i = levels_.size() - 1; i > 0; --i) {
        drawInto(levels_[i - 1], levels_[i].texture.id(), levels_[i].size, up);
    }
    glDisable(GL_BLEND);
}

void BloomPass::list(Resources& resources) const {
    gl::listProgram(resources, down_);
    gl::listProgram(resources, up_);
    for (const Level& level : levels_) gl::listTexture(resources, "bloom", GL_TEXTURE_2D, level.texture);
}

}  // namespace hazer::render
