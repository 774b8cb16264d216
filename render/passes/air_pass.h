// The light of every beam in the haze.
#pragma once

#include <filesystem>
#include <map>

#include "render/passes/beam_batch.h"
#include "render/profile_rule_store.h"

namespace hazer::render {

class AirPass {
 public:
    explicit AirPass(std::filesystem::path shaderFolder);

    /// Adds the beams of `groups`, of the plan's air groups or parts of them, to the bound framebuffer.
    void draw(const LightInputs& in, const std::vector<BeamGroup>& groups);

    /// Adds `countedAs` for each beam of `groups` that lights the haze along a pixel's ray.
    void count(const LightInputs& in, const std::vector<BeamGroup>& groups, float countedAs);

    /// Draws the hulls of `groups` with the current program.
    void drawHulls(const LightInputs& in, const std::vector<BeamGroup>& groups);

    /// Adds what there is on the GPU.
    void list(Resources& resources) const;

 private:
    void drawWith(const LightInputs& in, const std::vector<BeamGroup>& groups, LightFeatures further,
                  float countedAs);
    const gl::Program& variant(LightFeatures features);
    void setHaze(const gl::Program& program, const LightInputs& in);
    void makeNoise(std::uint32_t seed);
    void setNoise(const gl::Program& program, const LightInputs& in);

    /// The beams with what the air asks of their profiles: the rows of their rules, or their solid angles.
    std::vector<GpuBeam> withProfiles(const LightInputs& in, const std::vector<BeamGroup>& groups);

    std::filesystem::path shaderFolder_;
    std::map<LightFeatures, gl::Program> variants_;
    BeamBatch batch_;
    ProfileRuleStore rules_;
    gl::Texture noise_;
    std::uint32_t noiseSeed_ = 0;  ///< That noise_ was made from.
};

}  // namespace hazer::render
