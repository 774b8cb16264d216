#include "render/passes/lens_pass.h"

#include <array>

namespace hazer::render {

LensPass::LensPass(std::filesystem::path shaderFolder) : shaderFolder_(std::move(shaderFolder)) {}

void LensPass::draw(const LightInputs& in) {
    if (!program_) program_.emplace(shaderFolder_, "lens.vert", "lens.frag");
    const std::array<BeamGroup, 1> lenses{{{0, in.plan.lenses}}};
    batch_.upload(lenses, in.beams);
    program_->use();
    setLightUniforms(*program_, in);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    batch_.drawLenses(0);
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
}

}  // namespace hazer::render
