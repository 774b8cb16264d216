#include "render/passes/tone_map_pass.h"

#include <cmath>

#include "render/gl/inventory.h"
#include "render/gl/texture.h"

namespace hazer::render {
namespace {
// A clean camera lens scatters a few percent of what falls on it.
constexpr float kBloomShare = 0.03f;
}  // namespace

ToneMapPass::ToneMapPass(const std::filesystem::path& shaderFolder)
    : plain_(shaderFolder, "fullscreen.vert", "tone_map.frag"),
      withBloom_(shaderFolder, "fullscreen.vert", "tone_map.frag", {"BLOOM"}) {}

void ToneMapPass::draw(GLuint radiance, GLuint bloom, int width, int height, float exposureEv100) {
    const gl::Program& program = bloom != 0 ? withBloom_.get() : plain_.get();
    program.use();
    gl::bindTexture(0, GL_TEXTURE_2D, radiance);
    gl::bindTexture(1, GL_TEXTURE_2D, bloom);
    program.set("radianceBuffer", 0);
    program.set("bloomBuffer", 1);
    program.set("viewportPx", glm::vec2(width, height));
    program.set("exposure", 1.0f / (1.2f * std::exp2(exposureEv100)));
    program.set("bloomShare", kBloomShare);
    glBindVertexArray(noVertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void ToneMapPass::list(Resources& resources) const {
    gl::listProgram(resources, plain_);
    gl::listProgram(resources, withBloom_);
}

}  // namespace hazer::render
