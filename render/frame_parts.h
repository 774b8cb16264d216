// The parts of a frame one by one: whether a plan needs each, why, and what it takes.
#pragma once

#include <vector>

#include "render/plan_summary.h"

namespace hazer::render {

/// All of them, in the order in which a reader asks: the picture, bodies, light in the air, what shapes a
/// beam, shadows, lenses and bloom.
std::vector<FramePart> frameParts(const SummaryInputs& in);

}  // namespace hazer::render
