#include "app/window_haze.h"

namespace hazer::app {

void setExtinction(render::Haze& haze, float extinctionPerM) {
    const float scatteredShare =
        haze.extinctionPerM > 0.0f ? haze.scatteringPerM / haze.extinctionPerM : 1.0f;
    haze.extinctionPerM = extinctionPerM;
    haze.scatteringPerM = scatteredShare * extinctionPerM;
}

}  // namespace hazer::app
