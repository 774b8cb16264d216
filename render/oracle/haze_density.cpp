#include "render/oracle/haze_density.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "render/noise_volume.h"

namespace hazer::render::oracle {
namespace {

constexpr double kTwoPi = 6.28318530717958647692;

/// How fast the waves that stir the smoke go round.
constexpr glm::dvec3 kStirHz(0.037, 0.029, 0.043);

/// How far they push it, in tiles.
constexpr double kPush = 0.035;

/// What makes the noise of the volume, about 0.26..0.74, span 0..2 for an amount of 1.
constexpr double kContrast = 4.2;

using Bytes = std::vector<std::uint8_t>;

/// The volume at a place in tiles, between 0 and 1: trilinear, repeating.
double noiseAt(const Bytes& volume, const glm::dvec3& tiles) {
    const glm::dvec3 at = tiles * static_cast<double>(kNoiseSize) - 0.5;
    const glm::dvec3 base = glm::floor(at);
    const glm::dvec3 share = at - base;
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        std::size_t index = 0;
        double weight = 1.0;
        for (int axis = 2; axis >= 0; --axis) {
            const int step = (corner >> axis) & 1;
            const auto texel = static_cast<std::int64_t>(base[axis]) + step;
            const std::int64_t wrapped = ((texel % kNoiseSize) + kNoiseSize) % kNoiseSize;
            index = index * kNoiseSize + static_cast<std::size_t>(wrapped);
            weight *= step == 1 ? share[axis] : 1.0 - share[axis];
        }
        sum += weight * volume[index] / 255.0;
    }
    return sum;
}

}  // namespace

Density hazeDensity(const Haze& haze, double timeS) {
    const HazeNoise noise = haze.noise;
    if (noise.amount <= 0.0f) return {};
    const auto volume = std::make_shared<const Bytes>(makeNoiseVolume(kNoiseSize, noise.seed));
    return [noise, timeS, volume](const glm::dvec3& placeM) {
        const double tileM = kNoiseCells * static_cast<double>(noise.scaleM);
        glm::dvec3 tiles = (placeM - glm::dvec3(noise.windMps) * timeS) / tileM;
        const glm::dvec3 turned(tiles.y, tiles.z, tiles.x);
        tiles += kPush * glm::sin(kTwoPi *
                                  (2.0 * turned + kStirHz * (static_cast<double>(noise.turbulence) * timeS)));
        return std::max(1.0 + noise.amount * kContrast * (noiseAt(*volume, tiles) - 0.5), 0.0);
    };
}

}  // namespace hazer::render::oracle
