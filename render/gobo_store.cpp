#include "render/gobo_store.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

#include "render/error.h"
#include "render/gl/inventory.h"

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

}  // namespace

std::vector<std::uint8_t> goboTransmission(const std::uint8_t* rgba, int width, int height) {
    if (rgba == nullptr || width < 1 || height < 1)
        throw RenderError("A gobo picture is empty; give it at least one pixel");
    std::vector<std::uint8_t> texels;
    texels.reserve(4u * kGoboSize * kGoboSize);
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
            const glm::vec3 light = inside ? resample(rgba, width, height, fx * stepX, fy * stepY,
                                                      (fx + 1.0f) * stepX, (fy + 1.0f) * stepY)
                                           : glm::vec3(0.0f);
            for (int c = 0; c < 3; ++c)
                texels.push_back(static_cast<std::uint8_t>(std::lround(255.0f * light[c])));
            texels.push_back(255);
        }
    }
    return texels;
}

GoboId GoboStore::add(const std::uint8_t* rgba, int width, int height) {
    layers_.push_back(goboTransmission(rgba, width, height));
    return static_cast<GoboId>(layers_.size()) - 1;
}

GLuint GoboStore::texture() {
    if (uploaded_ == layers_.size()) return texture_.id();
    texture_ = gl::makeTexture();
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.id());
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA8, kGoboSize, kGoboSize, static_cast<GLsizei>(layers_.size()),
                 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    for (std::size_t i = 0; i < layers_.size(); ++i) {
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, static_cast<GLint>(i), kGoboSize, kGoboSize, 1, GL_RGBA,
                        GL_UNSIGNED_BYTE, layers_[i].data());
    }
    glGenerateMipmap(GL_TEXTURE_2D_ARRAY);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    uploaded_ = layers_.size();
    return texture_.id();
}

void GoboStore::list(Resources& resources) const {
    gl::listTexture(resources, "gobos", GL_TEXTURE_2D_ARRAY, texture_);
}

}  // namespace hazer::render
