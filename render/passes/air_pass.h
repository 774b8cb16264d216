// The light of every beam in the haze.
#pragma once

#include <filesystem>
#include <map>

#include "render/passes/beam_batch.h"

namespace hazer::render {

class AirPass {
 public:
    explicit AirPass(std::filesystem::path shaderFolder);

    /// Adds the plan's air groups to the bound framebuffer.
    void draw(const LightInputs& in);

    /// Draws the hulls of all air groups with the current program.
    void drawHulls(const LightInputs& in);

 private:
    const gl::Program& variant(LightFeatures features);
    void setHaze(const gl::Program& program, const LightInputs& in, LightFeatures features);
    void setNoise(const gl::Program& program, const LightInputs& in);

    std::filesystem::path shaderFolder_;
    std::map<LightFeatures, gl::Program> variants_;
    BeamBatch batch_;
    gl::Texture noise_;
};

}  // namespace hazer::render
