// The light of every beam on surfaces.
#pragma once

#include <filesystem>
#include <map>

#include "render/passes/beam_batch.h"

namespace hazer::render {

class LitSurfacePass {
 public:
    explicit LitSurfacePass(std::filesystem::path shaderFolder);

    /// Adds the plan's surface groups to the bound framebuffer, whose depth buffer is that of the surfaces.
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
