#include "render/passes/bloom_pass.h"

#include <algorithm>

#include "render/gl/texture.h"

namespace hazer::render {
namespace {
constexpr int kLevels = 6;
}

BloomPass::BloomPass(const std::filesystem::path& shaderFolder)
    : down_(shaderFolder, "fullscreen.vert", "bloom_down.frag"),
      up_(shaderFolder, "fullscreen.vert", "bloom_up.frag") {}

void BloomPass::resize(int width, int height) {
    width_ = width;
    height_ = height;
    levels_.clear();
    for (int i = 0; i < kLevels; ++i) {
        width = std::max(width / 2, 1);
        height = std::max(height / 2, 1);
        Level level{gl::makeTexture2d(GL_RGBA32F, width, height, GL_LINEAR), {}, width, height};
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
    glBindVertexArray(noVertices_.id());
    down_.use();
    drawInto(levels_[0], radiance, width_, height_, down_);
    for (std::size_t i = 1; i < levels_.size(); ++i) {
        drawInto(levels_[i], levels_[i - 1].texture.id(), levels_[i - 1].width, levels_[i - 1].height, down_);
    }
    // Each level becomes an even mix of itself and everything coarser, so that the weights sum to 1.
    glEnable(GL_BLEND);
    glBlendColor(0.0f, 0.0f, 0.0f, 0.5f);
    glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
    up_.use();
    for (std::size_t i = levels_.size() - 1; i > 0; --i) {
        const Level& target = levels_[i - 1];
        up_.set("targetPx", glm::vec2(target.width, target.height));
        drawInto(target, levels_[i].texture.id(), levels_[i].width, levels_[i].height, up_);
    }
    glDisable(GL_BLEND);
}

}  // namespace hazer::render
