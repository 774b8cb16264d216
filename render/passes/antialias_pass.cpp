#include "render/passes/antialias_pass.h"

#include "render/gl/texture.h"

namespace hazer::render {

AntialiasPass::AntialiasPass(const std::filesystem::path& shaderFolder)
    : program_(shaderFolder, "fullscreen.vert", "antialias.frag") {}

void AntialiasPass::draw(GLuint picture) {
    program_.use();
    gl::bindTexture(0, GL_TEXTURE_2D, picture);
    program_.set("source", 0);
    glBindVertexArray(noVertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace hazer::render
