#include "render/passes/display_grid.h"

#include "render/gl/inventory.h"
#include "render/gl/texture.h"

namespace hazer::render {

glm::ivec2 displayBlocks(int width, int height) {
    return (glm::ivec2(width, height) + kBlockPx - 1) / kBlockPx;
}

DisplayGrid::DisplayGrid(const std::filesystem::path& shaderFolder)
    : mean_(shaderFolder, "fullscreen.vert", "block_mean.frag"),
      mark_(shaderFolder, "fullscreen.vert", "block_mark.frag"),
      between_(shaderFolder, "fullscreen.vert", "block_between.frag"),
      shown_(shaderFolder, "fullscreen.vert", "block_shown.frag"),
      shownWithBloom_(shaderFolder, "fullscreen.vert", "block_shown.frag", {"BLOOM"}) {}

void DisplayGrid::resize(int width, int height) {
    size_ = {width, height};
    blocks_ = displayBlocks(width, height);
    means_ = gl::makeTexture2d(GL_RGBA32F, blocks_.x, blocks_.y, GL_LINEAR);
    shownColors_ = gl::makeTexture2d(GL_RGBA32F, blocks_.x, blocks_.y, GL_NEAREST);
    bloom_ = {};
    marked_ = gl::makeTexture2d(GL_RGBA32F, blocks_.x, blocks_.y, GL_LINEAR);
    mask_ = gl::makeTexture2d(GL_DEPTH_COMPONENT16, width, height, GL_NEAREST);
    meansTarget_ = gl::makeFramebufferFor({means_.id()});
    shownTarget_ = gl::makeFramebufferFor({shownColors_.id()});
    markedTarget_ = gl::makeFramebufferFor({marked_.id()});
}

void DisplayGrid::measure(GLuint radiance, float exposure) {
    glBindFramebuffer(GL_FRAMEBUFFER, meansTarget_.id());
    glViewport(0, 0, blocks_.x, blocks_.y);
    mean_.use();
    gl::bindTexture(0, GL_TEXTURE_2D, radiance);
    mean_.set("radianceBuffer", 0);
    mean_.set("exposure", exposure);
    glBindVertexArray(noVertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void DisplayGrid::allocateBloom() {
    bloom_ = gl::makeTexture2d(GL_RGBA32F, blocks_.x, blocks_.y, GL_LINEAR);
    shownTarget_ = gl::makeFramebufferFor({shownColors_.id(), bloom_.id()});
}

void DisplayGrid::show(const BloomPass* bloom, float exposure) {
    if (bloom != nullptr && bloom_.id() == 0) allocateBloom();
    const gl::Program& program = bloom != nullptr ? shownWithBloom_.get() : shown_.get();
    glBindFramebuffer(GL_FRAMEBUFFER, shownTarget_.id());
    program.use();
    gl::bindTexture(0, GL_TEXTURE_2D, means_.id());
    program.set("blocks", 0);
    program.set("exposure", exposure);
    if (bloom != nullptr) {
        gl::bindTexture(1, GL_TEXTURE_2D, bloom->texture());
        program.set("coarserBloom", 1);
        program.set("coarserTexel", 1.0f / glm::vec2(bloom->size()));
        program.set("bloomShare", kBloomShare);
    }
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void DisplayGrid::mark() {
    glBindFramebuffer(GL_FRAMEBUFFER, markedTarget_.id());
    mark_.use();
    gl::bindTexture(0, GL_TEXTURE_2D, shownColors_.id());
    mark_.set("shownBlocks", 0);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void DisplayGrid::drawBetween() {
    between_.use();
    gl::bindTexture(0, GL_TEXTURE_2D, marked_.id());
    between_.set("markedBlocks", 0);
    between_.set("blocksPerPx", blocksPerPx());
    glBindVertexArray(noVertices_.id());
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
}

void DisplayGrid::judge(const BloomPass* bloom, float exposure) {
    glViewport(0, 0, blocks_.x, blocks_.y);
    glBindVertexArray(noVertices_.id());
    show(bloom, exposure);
    mark();
}

// Between the depths of shaders/block_between.frag.
void DisplayGrid::onlyExact() {
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glDepthRange(0.25, 0.25);
}

void DisplayGrid::onlyEdges() {
    onlyExact();
    glDepthRange(0.75, 0.75);
}

void DisplayGrid::everywhere() {
    glDepthRange(0.0, 1.0);
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
}

void DisplayGrid::list(Resources& resources) const {
    for (const gl::Program* program : {&mean_, &mark_, &between_}) gl::listProgram(resources, *program);
    gl::listProgram(resources, shown_);
    gl::listProgram(resources, shownWithBloom_);
    gl::listTexture(resources, "block means", GL_TEXTURE_2D, means_);
    gl::listTexture(resources, "blocks shown", GL_TEXTURE_2D, shownColors_);
    gl::listTexture(resources, "blocks marked", GL_TEXTURE_2D, marked_);
    gl::listTexture(resources, "block bloom", GL_TEXTURE_2D, bloom_);
    gl::listTexture(resources, "display mask", GL_TEXTURE_2D, mask_);
}

}  // namespace hazer::render
