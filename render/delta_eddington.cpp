#include "render/delta_eddington.h"

#include <algorithm>

namespace hazer::render {

Haze hazeToIntegrate(Haze haze) {
    if (!haze.deltaEddington) return haze;
    const double g = std::max(static_cast<double>(haze.phase.forwardG), 0.0);
    const double weight = static_cast<double>(haze.phase.forwardWeight);
    const double scattering = static_cast<double>(haze.scatteringPerM);
    const double peak = weight * g * g;
    // The narrower lobe that is left has the mean cosine (g - g^2) / (1 - g^2).
    if (g > 0.0) haze.phase.forwardG = static_cast<float>(g / (1.0 + g));
    haze.phase.forwardWeight = static_cast<float>((weight - peak) / (1.0 - peak));
    haze.scatteringPerM = static_cast<float>((1.0 - peak) * scattering);
    // A haze that is said to scatter more than it takes away does not glow by itself.
    haze.extinctionPerM =
        static_cast<float>(std::max(static_cast<double>(haze.extinctionPerM) - peak * scattering, 0.0));
    return haze;
}

}  // namespace hazer::render
