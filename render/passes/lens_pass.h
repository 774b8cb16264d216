// The lenses of lit fixtures.
#pragma once

#include <filesystem>
#include <optional>

#include "render/passes/beam_batch.h"

namespace hazer::render {

class LensPass {
 public:
    explicit LensPass(std::filesystem::path shaderFolder);

    /// Adds the plan's lenses to the bound framebuffer, behind what stands before them (its depth buffer).
    void draw(const LightInputs& in);

 private:
    std::filesystem::path shaderFolder_;
    std::optional<gl::Program> program_;
    BeamBatch batch_;
};

}  // namespace hazer::render
