#include "render/oracle/haze_density.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "render/noise_volume.h"

namespace hazer::render::oracle {
namespace {

/// How fast the waves that stir the smoke go round.
constexpr glm::dvec3 kStirHz(0.037, 0.029, 0.043);

/// How far they push it, in tiles.
constexpr double kPush = 0.035;

/// The tiles are turned by this about that.
constexpr double kTurnRad = 75.0 * 3.14159265358979323846 / 180.0;
constexpr glm::dvec3 kTurnAxis(0.6, -0.48, 0.64);

using Values = std::vector<std::uint16_t>;

/// Rodrigues' rotation.
glm::dvec3 turned(const glm::dvec3& v) {
    return v * std::cos(kTurnRad) + glm::cross(kTurnAxis, v) * std::sin(kTurnRad) +
           kTurnAxis * (glm::dot(kTurnAxis, v) * (1.0 - std::cos(kTurnRad)));
}

/// -1 at a quarter of the period, 1 at three quarters, parabolas between its zeros.
double wave(double phase) {
    const double half = 2.0 * phase;
    const double in = half - std::floor(half);
    const bool isFirst = std::fmod(std::floor(half), 2.0) == 0.0;
    return (isFirst ? -4.0 : 4.0) * in * (1.0 - in);
}

/// Where the tile's texture has gone when the waves have pushed it along x, then y, then z.
glm::dvec3 stirred(glm::dvec3 tiles, const glm::dvec3& phase) {
    for (int axis = 0; axis < 3; ++axis) {
        tiles[axis] += kPush * wave(2.0 * tiles[(axis + 1) % 3] + phase[axis]);
    }
    return tiles;
}

/// The volume at a place in tiles, between 0 and 1: trilinear, repeating.
double noiseAt(const Values& volume, const glm::dvec3& tiles) {
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
        sum += weight * volume[index] / 65535.0;
    }
    return sum;
}

}  // namespace

Density hazeDensity(const Haze& haze, double timeS) {
    const HazeNoise noise = haze.noise;
    if (noise.amount <= 0.0f) return {};
    const auto volume = std::make_shared<const Values>(makeNoiseVolume(kNoiseSize, noise.seed));
    return [noise, timeS, volume](const glm::dvec3& placeM) {
        const double tileM = kNoiseCells * static_cast<double>(noise.scaleM);
        const glm::dvec3 tiles = turned(placeM - glm::dvec3(noise.windMps) * timeS) / tileM;
        const glm::dvec3 phase = kStirHz * (static_cast<double>(noise.turbulence) * timeS);
        return 1.0 + noise.amount * (2.0 * noiseAt(*volume, stirred(tiles, phase)) - 1.0);
    };
}

}  // namespace hazer::render::oracle
