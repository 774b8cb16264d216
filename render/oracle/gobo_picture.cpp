#include "render/oracle/gobo_picture.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace hazer::render::oracle {
namespace {

/// Texels along an edge of the most blurred picture.
constexpr int kCoarsest = 4;

std::size_t texelIndex(int size, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + static_cast<std::size_t>(x);
}

}  // namespace

GoboPicture::GoboPicture(std::span<const std::uint8_t> rgba, int size) {
    assert(size > 0 && rgba.size() == 4 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    Level finest{size, {}};
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        finest.texels.emplace_back(glm::dvec3(rgba[i], rgba[i + 1], rgba[i + 2]) / 255.0);
        isGrey_ = isGrey_ && rgba[i] == rgba[i + 1] && rgba[i] == rgba[i + 2];
    }
    levels_.push_back(std::move(finest));
    while (levels_.back().size > kCoarsest) levels_.push_back(halved(levels_.back()));
}

GoboPicture::Level GoboPicture::halved(const Level& fine) {
    Level coarse{fine.size / 2, {}};
    for (int y = 0; y < coarse.size; ++y) {
        for (int x = 0; x < coarse.size; ++x) {
            const auto at = [&](int dx, int dy) {
                return fine.texels[texelIndex(fine.size, 2 * x + dx, 2 * y + dy)];
            };
            coarse.texels.push_back(0.25 * (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1)));
        }
    }
    return coarse;
}

glm::dvec3 GoboPicture::bilinear(const Level& level, const glm::dvec2& uv) {
    const glm::dvec2 at = uv * static_cast<double>(level.size) - 0.5;
    const glm::dvec2 base = glm::floor(at);
    const glm::dvec2 share = at - base;
    const auto texel = [&](int dx, int dy) {
        const glm::dvec2 place = base + glm::dvec2(dx, dy);
        const double end = level.size;
        if (place.x < 0.0 || place.y < 0.0 || place.x >= end || place.y >= end) return glm::dvec3(0.0);
        return level.texels[texelIndex(level.size, static_cast<int>(place.x), static_cast<int>(place.y))];
    };
    return glm::mix(glm::mix(texel(0, 0), texel(1, 0), share.x), glm::mix(texel(0, 1), texel(1, 1), share.x),
                    share.y);
}

glm::dvec3 GoboPicture::transmission(const glm::dvec2& place, double blurTexels) const {
    const glm::dvec2 uv(0.5 + 0.5 * place.x, 0.5 - 0.5 * place.y);
    const double level =
        std::min(std::log2(std::max(blurTexels, 1.0)), static_cast<double>(levels_.size() - 1));
    const auto fine = static_cast<std::size_t>(level);
    const std::size_t coarse = std::min(fine + 1, levels_.size() - 1);
    return glm::mix(bilinear(levels_[fine], uv), bilinear(levels_[coarse], uv),
                    level - static_cast<double>(fine));
}

}  // namespace hazer::render::oracle
