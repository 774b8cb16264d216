// Which tables of gobos a frame wants. Pure: no OpenGL.
#pragma once

#include <vector>

#include "render/gobo_table.h"
#include "render/photometry.h"
#include "render/scene.h"
#include "render/scene_plan.h"

namespace hazer::render {

/// The table of a beam's gobo. None (gobo -1) without a gobo, and where the beam is too wide for a table. The
/// profile is rounded, finely, so that beams share.
GoboTableKey goboTableKey(const Beam& beam, const BeamShape& shape);

/// One key a beam of the scene: none where no table serves its light in the air. A given number of samples is
/// a reference without tables.
std::vector<GoboTableKey> goboTableKeys(const Scene& scene, const Settings& settings, const ScenePlan& plan);

}  // namespace hazer::render
