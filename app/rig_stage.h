// The stage of a rig that comes without a show: a floor, a little light, and cameras that see all of it.
#pragma once

#include "app/show.h"

namespace hazer::app {

/// Adds floor, work light and cameras "front", "side", "corner" and "inside" to a show that has none.
void setStage(Show& show);

}  // namespace hazer::app
