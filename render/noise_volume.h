// Tileable three-dimensional noise for uneven haze.
#pragma once

#include <cstdint>
#include <vector>

namespace hazer::render {

/// `size`^3 bytes, x fastest; tiles in all three directions. Gradient noise (Perlin 2002, "Improving noise")
/// in octaves with 4, 8, 16
/// ... cells along an edge and halving amplitude, as many as the size can hold. The mean is 127.5 within half
/// a step; the same seed gives the same bytes everywhere.
std::vector<std::uint8_t> makeNoiseVolume(int size, std::uint32_t seed);

/// Edge of the volume that is drawn with, in texels.
inline constexpr int kNoiseSize = 64;

/// Cells of the coarsest octave along an edge.
inline constexpr int kNoiseCells = 4;

}  // namespace hazer::render
