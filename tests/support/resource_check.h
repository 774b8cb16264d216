// Holds what a renderer really has on the GPU against what the summary of a plan says.
#pragma once

#include "render/plan_summary.h"
#include "render/renderer.h"

namespace hazer::test {

/// For a fresh renderer that has drawn one frame, the one of the summary: the same passes, textures and
/// compiled shaders; and no more bytes of buffers of any name.
void expectAsPlanned(const render::PlanSummary& summary, const render::Renderer& renderer);

std::vector<std::string> passNames(const render::Renderer& renderer);

}  // namespace hazer::test
