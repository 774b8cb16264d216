#include "render/air_quality.h"

#include <algorithm>
#include <cmath>

#include "render/scene.h"

namespace hazer::render {
namespace {

int count(double wanted, int least, int most) {
    return std::clamp(static_cast<int>(std::ceil(wanted)), least, most);
}

/// What a look at a gobo's table may cost, as a share of the light that comes through.
constexpr double kLeastTableError = 4e-3;

/// Beyond this it is texels of shadow maps that err.
constexpr int kMostShadowIntervals = 232;

/// A grid pays as long as most of its cells may be interpolated.
int gridStepFor(double maxError) {
    if (maxError >= 5e-3) return 4;
    return maxError >= 5e-4 ? 2 : 1;
}

}  // namespace

AirQuality airQualityFor(double maxError) {
    AirQuality quality;
    quality.gridStep = gridStepFor(maxError);
    // Pixels that err as much as they may are few: over a picture of many pixels, and small ones have no
    // grid, it is a quarter of that, as long as it is little.
    quality.gridTolerance = std::max(std::min(4.0 * maxError, 0.08), 0.8 * maxError);
    // What each number may cost: errors of different origin add up as squares, and hardly ever are two at
    // their worst.
    const double each = 0.6 * maxError;
    // Edges of shadows are found by bisection: what is missed are bodies between two looks, in few rays where
    // there are few.
    quality.shadowIntervals = count(std::max(std::sqrt(1.2 / each), 0.08 / each), 8, kMostShadowIntervals);
    // An edge is then off by a quarter of 1 / (N 2^n) of the stretch.
    quality.shadowBisections = maxError >= 0.01 ? 3 : 5;
    // A gobo in even cells, as blurred as they are long.
    quality.goboTaps = count(std::sqrt(6.0 / each), 12, 512);
    quality.goboTolerance = 1.6 * maxError;
    quality.goboLevelsApart = maxError >= kLeastTableError ? 1.0 : 0.0;
    // Even looks at uneven haze, each the mean around it.
    quality.noiseNodes = count(std::sqrt(1.9 / each), 4, 64);
    quality.profilePairs = maxError >= 0.02 ? 3 : 4;
    return quality;
}

AirQuality airQuality(const Settings& settings) {
    AirQuality quality = settings.quality
                             ? *settings.quality
                             : airQualityFor(settings.maxError > 0.0 ? settings.maxError : kDefaultMaxError);
    if (!settings.quality && settings.maxError <= 0.0) quality.gridStep = 1;
    if (settings.airStep > 0) quality.gridStep = settings.airStep;
    if (settings.integrator == Integrator::kUniform || settings.samples > 0) quality.gridStep = 1;
    return quality;
}

}  // namespace hazer::render
