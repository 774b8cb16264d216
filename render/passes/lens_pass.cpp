#include "render/passes/lens_pass.h"

#include "render/gl/inventory.h"

namespace hazer::render {
namespace {

/// Lenses have no shadows: where they face takes the place of those.
std::vector<GpuBeam> withNormals(const LightInputs& in) {
    std::vector<GpuBeam> lenses = in.beams;
    for (std::size_t i = 0; i < lenses.size(); ++i) {
        const Beam& beam = in.scene.beams[i];
        const glm::dvec3 normal = beam.lensNormal.value_or(-beam.worldFromBeam[2]);
        lenses[i].shadow = glm::vec4(glm::dvec4(glm::transpose(beam.worldFromBeam) * normal, 0.0));
    }
    return lenses;
}

}  // namespace

LensPass::LensPass(std::filesystem::path shaderFolder) : shaderFolder_(std::move(shaderFolder)) {}

const gl::Program& LensPass::variant(LightFeatures features) {
    const auto found = variants_.find(features);
    if (found != variants_.end()) return found->second;
    return variants_.try_emplace(features, shaderFolder_, "lens.vert", "lens.frag", featureDefines(features))
        .first->second;
}

void LensPass::draw(const LightInputs& in) {
    const std::vector<BeamGroup>& groups = in.plan.lenses;
    batch_.upload(groups, withNormals(in));
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const gl::Program& program = variant(groups[i].features);
        program.use();
        setLightUniforms(program, in);
        batch_.drawLenses(i);
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
}

void LensPass::list(Resources& resources) const {
    for (const auto& [features, program] : variants_) gl::listProgram(resources, program);
    batch_.list(resources, "beams of lenses");
}

}  // namespace hazer::render
