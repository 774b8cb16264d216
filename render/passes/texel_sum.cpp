#include "render/passes/texel_sum.h"

#include "render/gl/inventory.h"
#include "render/gl/texture.h"

namespace hazer::render {

/// EDGE of shaders/sum_texels.frag.
constexpr int kSumEdge = 32;

std::vector<glm::ivec2> texelSumSizes(glm::ivec2 size) {
    std::vector<glm::ivec2> sizes;
    do {
        size = (size + kSumEdge - 1) / kSumEdge;
        sizes.push_back(size);
    } while (size != glm::ivec2(1));
    return sizes;
}

TexelSum::TexelSum(const std::filesystem::path& shaderFolder)
    : program_(shaderFolder, "fullscreen.vert", "sum_texels.frag") {}

void TexelSum::resize(glm::ivec2 size) {
    steps_.clear();
    for (const glm::ivec2& stepSize : texelSumSizes(size)) {
        gl::Texture texture = gl::makeTexture2d(GL_RGBA32F, stepSize.x, stepSize.y, GL_NEAREST);
        gl::Framebuffer target = gl::makeFramebufferFor({texture.id()});
        steps_.push_back({std::move(texture), std::move(target), stepSize});
    }
}

void TexelSum::draw(GLuint source) {
    const gl::Program& program = program_.get();
    program.use();
    program.set("source", 0);
    glBindVertexArray(noVertices_.id());
    for (const Step& step : steps_) {
        glBindFramebuffer(GL_FRAMEBUFFER, step.target.id());
        glViewport(0, 0, step.size.x, step.size.y);
        gl::bindTexture(0, GL_TEXTURE_2D, source);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        source = step.texture.id();
    }
}

void TexelSum::list(Resources& resources) const {
    gl::listProgram(resources, program_);
    for (const Step& step : steps_) gl::listTexture(resources, "grid sums", GL_TEXTURE_2D, step.texture);
}

}  // namespace hazer::render
