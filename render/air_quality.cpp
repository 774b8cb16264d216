#include "render/air_quality.h"

#include <algorithm>
#include <cmath>

namespace hazer::render {
namespace {

int count(double wanted, int least, int most) {
    return std::clamp(static_cast<int>(std::ceil(wanted)), least, most);
}

/// A grid pays as long as most of its cells may be interpolated.
int gridStepFor(double maxError) {
    if (maxError >= 5e-3) return 4;
    return maxError >= 5e-4 ? 2 : 1;
}

}  // namespace

AirQuality airQualityFor(double maxError) {
    AirQuality quality;
    quality.gridStep = gridStepFor(maxError);
    // Pixels that err as much as they may are few: over the picture it is a quarter of that, as long as it is
    // little.
    quality.gridTolerance = std::min(4.0 * maxError, 0.08);
    // Shadow edges are found by bisection: what is missed are occluders between two looks, 1 / N^2.
    quality.shadowIntervals = count(std::sqrt(1.1 / maxError), 8, 29);
    // Even taps over a picture with edges: 1 / N.
    quality.goboTaps = count(0.32 / maxError, 16, 512);
    // Even looks at smooth noise: 1 / N^2, and its contrast.
    quality.noiseNodes = count(0.8 / std::sqrt(maxError), 6, 64);
    quality.profilePairs = maxError >= 0.02 ? 3 : 4;
    return quality;
}

AirQuality airQuality(const Settings& settings) {
    AirQuality quality = airQualityFor(settings.maxError > 0.0 ? settings.maxError : kDefaultMaxError);
    if (settings.maxError <= 0.0) quality.gridStep = 1;
    if (settings.airStep > 0) quality.gridStep = settings.airStep;
    if (settings.integrator == Integrator::kUniform || settings.samples > 0) quality.gridStep = 1;
    return quality;
}

}  // namespace hazer::render
