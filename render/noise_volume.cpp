#include "render/noise_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>
#include <numeric>
#include <utility>

namespace hazer::render {
namespace {

/// A lattice of gradients: the tile times an integer matrix whose rows are perpendicular and all of the
/// length `cells`, which is a rotation but for its size. The lattice therefore fits the tile, yet lies askew
/// to it.
struct Octave {
    int cells;
    std::array<glm::ivec3, 3> rows;
};

constexpr std::array<Octave, 3> kOctaves{{{3, {{{1, 2, 2}, {2, 1, -2}, {2, -2, 1}}}},
                                          {7, {{{2, 3, 6}, {3, -6, 2}, {6, 2, -3}}}},
                                          {15, {{{2, 10, 11}, {14, -5, 2}, {5, 10, -10}}}}}};
static_assert(kOctaves.front().cells == kNoiseCells);

constexpr std::size_t kDirections = 64;

/// Evenly spread over the sphere, along a spiral.
std::array<glm::vec3, kDirections> spreadDirections() {
    std::array<glm::vec3, kDirections> directions;
    for (std::size_t i = 0; i < kDirections; ++i) {
        const double z = (2.0 * static_cast<double>(i) + 1.0) / kDirections - 1.0;
        const double turn = glm::two_pi<double>() * glm::golden_ratio<double>() * static_cast<double>(i);
        const double across = std::sqrt(1.0 - z * z);
        directions[i] = glm::vec3(across * std::cos(turn), across * std::sin(turn), z);
    }
    return directions;
}

/// Wellons' lowbias32.
std::uint32_t hash(std::uint32_t h) {
    h = (h ^ (h >> 16)) * 0x7feb352du;
    h = (h ^ (h >> 15)) * 0x846ca68bu;
    return h ^ (h >> 16);
}

/// The gradient at a lattice point; points a tile apart have the same.
const glm::vec3& gradient(const glm::ivec3& point, const Octave& octave, std::uint32_t seed) {
    static const std::array<glm::vec3, kDirections> kSpread = spreadDirections();
    // The transposed matrix is the inverse times the square of the size: a tile further is that square
    // further.
    const int tile = octave.cells * octave.cells;
    std::uint32_t h = seed;
    for (int axis = 0; axis < 3; ++axis) {
        int place = 0;
        for (int row = 0; row < 3; ++row)
            place += octave.rows[static_cast<std::size_t>(row)][axis] * point[row];
        h = hash(h + static_cast<std::uint32_t>((place % tile + tile) % tile));
    }
    return kSpread[h % kDirections];
}

float fade(float t) {
    return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
}

/// Gradient noise at a place in the tile, about -1..1.
float gradientNoise(const glm::vec3& place, const Octave& octave, std::uint32_t seed) {
    const glm::vec3 p(glm::dot(glm::vec3(octave.rows[0]), place), glm::dot(glm::vec3(octave.rows[1]), place),
                      glm::dot(glm::vec3(octave.rows[2]), place));
    const glm::vec3 base = glm::floor(p);
    const glm::vec3 f = p - base;
    const glm::vec3 w(fade(f.x), fade(f.y), fade(f.z));
    float sum = 0.0f;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 step(corner & 1, (corner >> 1) & 1, (corner >> 2) & 1);
        const glm::vec3 share = glm::mix(1.0f - w, w, glm::vec3(step));
        sum += share.x * share.y * share.z *
               glm::dot(gradient(glm::ivec3(base) + step, octave, seed), f - glm::vec3(step));
    }
    return sum;
}

float octaves(const glm::vec3& place, std::uint32_t seed) {
    float sum = 0.0f;
    float amplitude = 1.0f;
    for (const Octave& octave : kOctaves) {
        sum +=
            amplitude * gradientNoise(place, octave, hash(seed) + static_cast<std::uint32_t>(octave.cells));
        amplitude *= 0.5f;
    }
    return sum;
}

/// What the share `below` 0..1 of all values is smaller than, where they lie in -1..1 with the density of a
/// parabola: the root of (2 + 3 x - x^3) / 4 = below.
double parabolaQuantile(double below) {
    return 2.0 * std::sin(std::asin(2.0 * below - 1.0) / 3.0);
}

/// The values by their order, smallest first. Those of the upper half are what the lower ones lack to the
/// full range, so that the mean is its middle to the last digit.
std::vector<std::uint16_t> orderedValues(std::size_t count) {
    std::vector<std::uint16_t> values(count);
    for (std::size_t i = 0; i < count / 2; ++i) {
        const double below = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
        const auto value = static_cast<std::uint16_t>(std::lround(32767.5 * (1.0 + parabolaQuantile(below))));
        values[i] = value;
        values[count - 1 - i] = static_cast<std::uint16_t>(65535 - value);
    }
    return values;
}

std::vector<std::uint16_t> halved(const std::vector<std::uint16_t>& level, int size) {
    const auto at = [&](int x, int y, int z) -> std::uint32_t {
        return level[static_cast<std::size_t>((z * size + y) * size + x)];
    };
    std::vector<std::uint16_t> result;
    result.reserve(level.size() / 8);
    for (int z = 0; z < size; z += 2) {
        for (int y = 0; y < size; y += 2) {
            for (int x = 0; x < size; x += 2) {
                std::uint32_t sum = 0;
                for (int i = 0; i < 8; ++i) sum += at(x + (i & 1), y + ((i >> 1) & 1), z + (i >> 2));
                // Halves go to the even neighbour, so that rounding does not drift from level to level.
                result.push_back(static_cast<std::uint16_t>((sum + 3 + ((sum >> 3) & 1)) >> 3));
            }
        }
    }
    return result;
}

}  // namespace

std::vector<std::uint16_t> makeNoiseVolume(int size, std::uint32_t seed) {
    std::vector<std::pair<float, std::uint32_t>> order;
    const float texel = 1.0f / static_cast<float>(size);
    for (int z = 0; z < size; ++z) {
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const glm::vec3 place = (glm::vec3(x, y, z) + 0.5f) * texel;
                order.emplace_back(octaves(place, seed), static_cast<std::uint32_t>(order.size()));
            }
        }
    }
    std::sort(order.begin(), order.end());
    const std::vector<std::uint16_t> values = orderedValues(order.size());
    std::vector<std::uint16_t> volume(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) volume[order[i].second] = values[i];
    return volume;
}

std::vector<std::vector<std::uint16_t>> noiseLevels(std::vector<std::uint16_t> volume, int size) {
    std::vector<std::vector<std::uint16_t>> levels{std::move(volume)};
    for (; size > 1; size /= 2) levels.push_back(halved(levels.back(), size));
    return levels;
}

}  // namespace hazer::render
