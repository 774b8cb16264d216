#include "render/passes/bloom_pass.h"

#include <algorithm>

#include "render/gl/inventory.h"
#include "render/gl/texture.h"

namespace hazer::render {
namespace {
constexpr int kLevels = 6;
}

std::vector<glm::ivec2> bloomLevelSizes(int width, int height) {
    std::vector<glm::ivec2> sizes;
    for (int i = 0; i < kLevels; ++i) {
        width = std::max(width / 2, 1);
        height = std::max(height / 2, 1);
        sizes.emplace_back(width, height);
    }
    return sizes;
}

BloomPass::BloomPass(const std::filesystem::path& shaderFolder)
    : down_(shaderFolder, "fullscreen.vert", "bloom_down.frag"),
      up_(shaderFolder, "fullscreen.vert", "bloom_up.frag") {}

void BloomPass::resize(int width, int height) {
    width_ = width;
    height_ = height;
    levels_.clear();
}

void BloomPass::allocate() {
    for (const glm::ivec2& size : bloomLevelSizes(width_, height_)) {
        Level level{gl::makeTexture2d(GL_RGBA32F, size.x, size.y, GL_LINEAR), {}, size.x, size.y};
        level.framebuffer = gl::makeFramebufferFor({level.texture.id()});
        levels_.push_back(std::move(level));
    }
}

void BloomPass::drawInto(const Level& target, GLuint source, int sourceWidth, int sourceHeight,
                         const gl::Program& program) {
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
    glViewport(0, 0, target.width, target.height);
    gl::bindTexture(0, GL_TEXTURE_2D, source);
    program.set("source", 0);
    program.set("sourceTexel",
                glm::vec2(1.0f / static_cast<float>(sourceWidth), 1.0f / static_cast<float>(sourceHeight)));
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void BloomPass::draw(GLuint radiance) {
    if (levels_.empty()) allocate();
    const gl::Program& down = down_.get();
    const gl::Program& up = up_.get();
    glBindVertexArray(noVertices_.id());
    down.use();
    drawInto(levels_[0], radiance, width_, height_, down);
    for (std::size_t i = 1; i < levels_.size(); ++i) {
        drawInto(levels_[i], levels_[i - 1].texture.id(), levels_[i - 1].width, levels_[i - 1].height, down);
    }
    // Each level becomes an even mix of itself and everything coarser, so that the weights sum to 1.
    glEnable(GL_BLEND);
    glBlendColor(0.0f, 0.0f, 0.0f, 0.5f);
    glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
    up.use();
    for (std::size_t i = levels_.size() - 1; i > 0; --i) {
        const Level& target = levels_[i - 1];
        up.set("targetPx", glm::vec2(target.width, target.height));
        drawInto(target, levels_[i].texture.id(), levels_[i].width, levels_[i].height, up);
    }
    glDisable(GL_BLEND);
}

void BloomPass::list(Resources& resources) const {
    gl::listProgram(resources, down_);
    gl::listProgram(resources, up_);
    for (const Level& level : levels_) gl::listTexture(resources, "bloom", GL_TEXTURE_2D, level.texture);
}

}  // namespace hazer::render
