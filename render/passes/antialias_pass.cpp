#include "render/passes/antialias_pass.h"

#include "render/gl/texture.h"

namespace hazer::render {

AntialiasPass::AntialiasPass(const std::filesystem::path& shaderFolder)
    : program_(shaderFolder, "fullscreen.vert", "antialias.frag") {}

void AntialiasPass::draw(GLuint display, int width, int height) {
    program_.use();
    gl::bindTexture(0, GL_TEXTURE_2D, display);
    program_.set("source", 0);
    program_.set("texel", glm::vec2(1.0f / static_cast<float>(width), 1.0f / static_cast<float>(height)));
    glBindVertexArray(noVertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace hazer::render
