// The converged picture against the oracle. Built without Embree (HAZER_ORACLE=OFF) it only says so.
#pragma once

#include <optional>
#include <string>

#include "app/report/accuracy_report.h"
#include "render/image.h"
#include "render/renderer.h"

namespace hazer::app {

/// A check, or a sentence that says why there is none.
struct OracleResult {
    std::optional<OracleCheck> check;
    std::string why;
};

/// Compares up to `pixels` lit pixels, always the same ones of a picture, with what the oracle says about the
/// light in the air and on surfaces at their centres. `picture` is `scene` as the renderer drew it, without
/// lenses; the renderer still knows the scene's meshes, gobos and webs.
OracleResult checkAgainstOracle(const render::FloatImage& picture, const render::Scene& scene,
                                const render::Camera& camera, const render::Renderer& renderer, int pixels);

}  // namespace hazer::app
