// The haze as one fader moves it.
#pragma once

#include "render/scene.h"

namespace hazer::app {

/// Sets how much light the haze takes from a beam [1/m], >= 0. The share of it that is scattered stays, so
/// that the air gets denser without getting darker or brighter smoke; haze that was not there scatters all.
void setExtinction(render::Haze& haze, float extinctionPerM);

}  // namespace hazer::app
