#include "render/passes/lit_surface_pass.h"

#include "render/gl/inventory.h"

namespace hazer::render {

LitSurfacePass::LitSurfacePass(std::filesystem::path shaderFolder) : shaderFolder_(std::move(shaderFolder)) {}

const gl::Program& LitSurfacePass::variant(LightFeatures features) {
    const auto found = variants_.find(features);
    if (found != variants_.end()) return found->second;
    return variants_
        .try_emplace(features, shaderFolder_, "beam.vert", "lit_surface.frag", featureDefines(features))
        .first->second;
}

void LitSurfacePass::draw(const LightInputs& in) {
    batch_.upload(in.plan.surfaceGroups, in.beams);
    // A surface is lit only where it stands before the far side of a cone. The empty sky's depth of 1 is
    // farther than any hull can reach in this range.
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GEQUAL);
    glDepthMask(GL_FALSE);
    glDepthRange(0.0, 1.0 - 1e-6);
    for (std::size_t i = 0; i < in.plan.surfaceGroups.size(); ++i) {
        const gl::Program& program = variant(in.plan.surfaceGroups[i].features);
        program.use();
        setLightUniforms(program, in);
        batch_.drawHulls(i);
    }
    glDepthRange(0.0, 1.0);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
}

void LitSurfacePass::list(Resources& resources) const {
    for (const auto& [features, program] : variants_) gl::listProgram(resources, program);
    batch_.list(resources, "beams on surfaces");
}

}  // namespace hazer::render
