// The lenses of lit fixtures.
#pragma once

#include <filesystem>
#include <map>

#include "render/passes/beam_batch.h"

namespace hazer::render {

class LensPass {
 public:
    explicit LensPass(std::filesystem::path shaderFolder);

    /// Adds the plan's lenses to the bound framebuffer, behind what stands before them (its depth buffer).
    void draw(const LightInputs& in);

    /// Adds what there is on the GPU.
    void list(Resources& resources) const;

 private:
    const gl::Program& variant(LightFeatures features);

    std::filesystem::path shaderFolder_;
    std::map<LightFeatures, gl::Program> variants_;
    BeamBatch batch_;
};

}  // namespace hazer::render
