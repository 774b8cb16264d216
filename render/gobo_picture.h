// What a gobo lets through, as a picture with mip levels. Pure CPU.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace hazer::render {

/// Texels along an edge of level 0; the field of the beam is the inscribed circle.
inline constexpr int kGoboSize = 512;
/// Level l has kGoboSize >> l texels along an edge; the last has 4.
inline constexpr int kGoboLevels = 8;

/// Linear transmission, 0..255 for 0..1; RGBA, row 0 on top, black outside the inscribed circle. A texel of a
/// level is the mean of four of the level before. Looked up bilinearly, level l blurs the gobo as much as a
/// disc of 2^l texels' radius does.
struct GoboPicture {
    std::array<std::vector<std::uint8_t>, kGoboLevels> levels;
    bool grey = true;  ///< Red, green and blue nowhere differ by two steps.
};

/// From an sRGB RGBA picture of any size, row 0 on top; see Renderer::addGobo. Throws RenderError if it is
/// empty.
GoboPicture makeGoboPicture(const std::uint8_t* rgba, int width, int height);

}  // namespace hazer::render
