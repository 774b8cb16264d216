// How fine shadow maps are, and which lamps go without for want of memory. A pure function; no GL.
#pragma once

#include <vector>

#include "render/shadow_plan.h"

namespace hazer::render {

/// Gives every map of the plan its tile sizes: as fine as the picture shows it, lamps much dimmer than the
/// brightest coarser; all halved until they fit kMostShadowTexels. Where not even the smallest tiles fit,
/// moves the dimmest lamps from `maps` to `leftOut`.
void chooseTileSizes(const Scene& scene, const std::vector<BeamShape>& shapes, const ShadowDetail& detail,
                     ShadowPlan& plan);

}  // namespace hazer::render
