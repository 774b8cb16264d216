#include "render/noise_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <numeric>

namespace hazer::render {
namespace {

/// A gradient per lattice point, by hashing its wrapped coordinates (integer hash: Wellons' lowbias32).
glm::vec3 gradient(int x, int y, int z, std::uint32_t seed) {
    std::uint32_t h = static_cast<std::uint32_t>(x) + 131u * static_cast<std::uint32_t>(y) +
                      17161u * static_cast<std::uint32_t>(z) + seed * 2654435761u;
    h = (h ^ (h >> 16)) * 0x7feb352du;
    h = (h ^ (h >> 15)) * 0x846ca68bu;
    h ^= h >> 16;
    static constexpr std::array<glm::vec3, 12> kEdges{{{1, 1, 0},
                                                       {-1, 1, 0},
                                                       {1, -1, 0},
                                                       {-1, -1, 0},
                                                       {1, 0, 1},
                                                       {-1, 0, 1},
                                                       {1, 0, -1},
                                                       {-1, 0, -1},
                                                       {0, 1, 1},
                                                       {0, -1, 1},
                                                       {0, 1, -1},
                                                       {0, -1, -1}}};
    return kEdges[h % kEdges.size()];
}

float fade(float t) {
    return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
}

/// Gradient noise with `cells` cells before it repeats; about -1..1.
float gradientNoise(const glm::vec3& p, int cells, std::uint32_t seed) {
    const glm::vec3 base = glm::floor(p);
    const glm::vec3 f = p - base;
    const glm::vec3 w(fade(f.x), fade(f.y), fade(f.z));
    float sum = 0.0f;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 step(corner & 1, (corner >> 1) & 1, (corner >> 2) & 1);
        const glm::ivec3 lattice = (glm::ivec3(base) + step) % cells;
        const glm::vec3 offset = f - glm::vec3(step);
        const glm::vec3 share = glm::mix(1.0f - w, w, glm::vec3(step));
        sum +=
            share.x * share.y * share.z * glm::dot(gradient(lattice.x, lattice.y, lattice.z, seed), offset);
    }
    return sum;
}

}  // namespace

std::vector<std::uint8_t> makeNoiseVolume(int size, std::uint32_t seed) {
    std::vector<float> values;
    values.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size) *
                   static_cast<std::size_t>(size));
    for (int z = 0; z < size; ++z) {
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                float sum = 0.0f;
                float amplitude = 1.0f;
                for (int cells = kNoiseCells; cells * 4 <= size; cells *= 2) {
                    const glm::vec3 p =
                        (glm::vec3(x, y, z) + 0.5f) * (static_cast<float>(cells) / static_cast<float>(size));
                    sum += amplitude * gradientNoise(p, cells, seed + static_cast<std::uint32_t>(cells));
                    amplitude *= 0.5f;
                }
                values.push_back(sum);
            }
        }
    }
    const float mean =
        std::accumulate(values.begin(), values.end(), 0.0f) / static_cast<float>(values.size());
    std::vector<std::uint8_t> bytes;
    bytes.reserve(values.size());
    for (const float value : values) {
        bytes.push_back(static_cast<std::uint8_t>(
            std::lround(std::clamp(127.5f + 110.0f * (value - mean), 0.0f, 255.0f))));
    }
    return bytes;
}

}  // namespace hazer::render
