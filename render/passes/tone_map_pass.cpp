#include "render/passes/tone_map_pass.h"

#include "render/gl/inventory.h"
#include "render/gl/texture.h"

namespace hazer::render {

ToneMapPass::ToneMapPass(const std::filesystem::path& shaderFolder)
    : plain_(shaderFolder, "fullscreen.vert", "tone_map.frag"),
      withBloom_(shaderFolder, "fullscreen.vert", "tone_map.frag", {"BLOOM"}) {}

void ToneMapPass::draw(GLuint radiance, const DisplayGrid& grid, bool withBloom, float exposure) {
    const gl::Program& program = withBloom ? withBloom_.get() : plain_.get();
    program.use();
    gl::bindTexture(0, GL_TEXTURE_2D, radiance);
    gl::bindTexture(1, GL_TEXTURE_2D, grid.bloom());
    program.set("radianceBuffer", 0);
    program.set("bloomBuffer", 1);
    program.set("blocksPerPx", grid.blocksPerPx());
    program.set("exposure", exposure);
    program.set("bloomShare", kBloomShare);
    glBindVertexArray(noVertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void ToneMapPass::list(Resources& resources) const {
    gl::listProgram(resources, plain_);
    gl::listProgram(resources, withBloom_);
}

}  // namespace hazer::render
