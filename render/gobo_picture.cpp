#include "render/gobo_picture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <glm/glm.hpp>

#include "render/error.h"

namespace hazer::render {
namespace {

/// IEC 61966-2-1.
std::array<float, 256> makeLinearFromSrgb() {
    std::array<float, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        const float c = static_cast<float>(i) / 255.0f;
        table[i] = c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
    }
    return table;
}

/// Linear transmission of one source pixel: colour times alpha (GDTF, annex E).
glm::vec3 transmission(const std::uint8_t* rgba, int width, int x, int y) {
    static const std::array<float, 256> kLinear = makeLinearFromSrgb();
    const std::uint8_t* p = rgba + 4 * (static_cast<std::ptrdiff_t>(y) * width + x);
    return glm::vec3(kLinear[p[0]], kLinear[p[1]], kLinear[p[2]]) * (static_cast<float>(p[3]) / 255.0f);
}

/// Mean of the source pixels under one target texel when shrinking, bilinear when enlarging.
glm::vec3 resample(const std::uint8_t* rgba, int width, int height, float x0, float y0, float x1, float y1) {
    const float cx = 0.5f * (x0 + x1);
    const float cy = 0.5f * (y0 + y1);
    const float halfX = std::max(0.5f * (x1 - x0), 0.5f);
    const float halfY = std::max(0.5f * (y1 - y0), 0.5f);
    glm::vec3 sum(0.0f);
    float weights = 0.0f;
    for (int y = static_cast<int>(std::floor(cy - halfY)); y <= static_cast<int>(std::floor(cy + halfY));
         ++y) {
        for (int x = static_cast<int>(std::floor(cx - halfX)); x <= static_cast<int>(std::floor(cx + halfX));
             ++x) {
            const float wx =
                std::min(cx + halfX, static_cast<float>(x + 1)) - std::max(cx - halfX, static_cast<float>(x));
            const float wy =
                std::min(cy + halfY, static_cast<float>(y + 1)) - std::max(cy - halfY, static_cast<float>(y));
            if (wx <= 0.0f || wy <= 0.0f) continue;
            sum += wx * wy *
                   transmission(rgba, width, std::clamp(x, 0, width - 1), std::clamp(y, 0, height - 1));
            weights += wx * wy;
        }
    }
    return sum / std::max(weights, 1e-6f);
}

std::vector<glm::vec3> sharpLevel(const std::uint8_t* rgba, int width, int height) {
    std::vector<glm::vec3> texels;
    texels.reserve(static_cast<std::size_t>(kGoboSize) * kGoboSize);
    const float stepX = static_cast<float>(width) / kGoboSize;
    const float stepY = static_cast<float>(height) / kGoboSize;
    for (int y = 0; y < kGoboSize; ++y) {
        for (int x = 0; x < kGoboSize; ++x) {
            const glm::vec2 fromCenter =
                2.0f * (glm::vec2(x, y) + 0.5f) / static_cast<float>(kGoboSize) - 1.0f;
            // The holder blocks what is outside; makers' pictures often leave that to the program.
            const bool inside = glm::length(fromCenter) < 1.0f - 2.0f / kGoboSize;
            const auto fx = static_cast<float>(x);
            const auto fy = static_cast<float>(y);
            texels.push_back(inside ? resample(rgba, width, height, fx * stepX, fy * stepY,
                                               (fx + 1.0f) * stepX, (fy + 1.0f) * stepY)
                                    : glm::vec3(0.0f));
        }
    }
    return texels;
}

std::vector<std::uint8_t> asBytes(const std::vector<glm::vec3>& texels) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(4 * texels.size());
    for (const glm::vec3& light : texels) {
        for (int c = 0; c < 3; ++c)
            bytes.push_back(static_cast<std::uint8_t>(std::lround(255.0f * light[c])));
        bytes.push_back(255);
    }
    return bytes;
}

/// Means of two by two texels.
std::vector<glm::vec3> halved(const std::vector<glm::vec3>& texels, int size) {
    std::vector<glm::vec3> result;
    result.reserve(texels.size() / 4);
    for (int y = 0; y < size; y += 2) {
        for (int x = 0; x < size; x += 2) {
            const auto at = [&](int right, int below) {
                return texels[static_cast<std::size_t>((y + below) * size + x + right)];
            };
            result.push_back(0.25f * (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1)));
        }
    }
    return result;
}

bool isGrey(const std::vector<std::uint8_t>& bytes) {
    for (std::size_t i = 0; i < bytes.size(); i += 4) {
        const auto [least, most] = std::minmax({bytes[i], bytes[i + 1], bytes[i + 2]});
        if (most - least >= 2) return false;
    }
    return true;
}

}  // namespace

GoboPicture makeGoboPicture(const std::uint8_t* rgba, int width, int height) {
    if (rgba == nullptr || width < 1 || height < 1)
        throw RenderError("A gobo picture is empty; give it at least one pixel");
    GoboPicture picture;
    std::vector<glm::vec3> texels = sharpLevel(rgba, width, height);
    for (int level = 0; level < kGoboLevels; ++level) {
        if (level > 0) texels = halved(texels, kGoboSize >> (level - 1));
        picture.levels[static_cast<std::size_t>(level)] = asBytes(texels);
    }
    picture.grey = isGrey(picture.levels[0]);
    return picture;
}

}  // namespace hazer::render
