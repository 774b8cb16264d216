#include "render/passes/lit_surface_pass.h"

#include "render/camera.h"
#include "render/gl/inventory.h"

namespace hazer::render {

LitSurfacePass::LitSurfacePass(std::filesystem::path shaderFolder) : shaderFolder_(std::move(shaderFolder)) {}

const gl::Program& LitSurfacePass::variant(LightFeatures features) {
    const auto found = variants_.find(features);
    if (found != variants_.end()) return found->second;
    return variants_
        .try_emplace(features, shaderFolder_, "lit_surface.vert", "lit_surface.frag",
                     featureDefines(features))
        .first->second;
}

void LitSurfacePass::draw(const LightInputs& in) {
    batch_.upload(in.plan.surfaceGroups, in.beams);
    // A surface is lit only where it stands before the far side of a hull.
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GEQUAL);
    glDepthMask(GL_FALSE);
    const glm::vec3 upInView(glm::transpose(worldFromView(in.camera)) * glm::dvec3(0.0, 0.0, 1.0));
    for (std::size_t i = 0; i < in.plan.surfaceGroups.size(); ++i) {
        const gl::Program& program = variant(in.plan.surfaceGroups[i].features);
        program.use();
        setLightUniforms(program, in);
        program.set("upInView", upInView);
        batch_.drawHulls(i);
    }
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
}

void LitSurfacePass::list(Resources& resources) const {
    for (const auto& [features, program] : variants_) gl::listProgram(resources, program);
    batch_.list(resources, "beams on surfaces");
}

}  // namespace hazer::render
