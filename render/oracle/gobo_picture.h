// What a gobo lets through, by the definition of its picture: means over squares of texels.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace hazer::render::oracle {

class GoboPicture {
 public:
    /// Linear transmission, size x size RGBA bytes (alpha is not used), row 0 on top; size is a power of two.
    GoboPicture(std::span<const std::uint8_t> rgba, int size);

    bool isGrey() const { return isGrey_; }
    int size() const { return levels_.front().size; }

    /// Transmission at a place of the unit disc, x to the right and y up as the picture is seen, for a blur
    /// as wide as `blurTexels` texels: bilinear in the picture of means over squares of that width, linear
    /// between powers of two, up to 1/4 of the picture. It is dark beyond its edge.
    glm::dvec3 transmission(const glm::dvec2& place, double blurTexels) const;

 private:
    struct Level {
        int size = 0;
        std::vector<glm::dvec3> texels;
    };
    static Level halved(const Level& fine);
    static glm::dvec3 bilinear(const Level& level, const glm::dvec2& uv);

    std::vector<Level> levels_;
    bool isGrey_ = true;
};

}  // namespace hazer::render::oracle
