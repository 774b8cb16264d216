// Tileable three-dimensional noise for uneven haze.
#pragma once

#include <cstdint>
#include <vector>

namespace hazer::render {

/// Texels along an edge of the volume that is drawn with.
inline constexpr int kNoiseSize = 64;

/// Cells of the coarsest octave along an edge.
inline constexpr int kNoiseCells = 3;

/// A volume of `size`^3 values, x fastest, that tiles in all three directions. Octaves of gradient noise
/// (Perlin 2002, "Improving noise") with 3, 7 and 15 cells along an edge and halving amplitude, each with a
/// lattice turned against the others, give the order of the values; what they are follows from that order
/// alone: 0..65535 with the density of a parabola, symmetric about 32767.5. So mean and variance (1/5 of the
/// square of half the range) are the same whatever the seed. `size` is even.
std::vector<std::uint16_t> makeNoiseVolume(int size, std::uint32_t seed);

/// All mip levels of a volume of `size`, a power of two: level 0 is `volume`, each further one the means of
/// its boxes, the last a single value.
std::vector<std::vector<std::uint16_t>> noiseLevels(std::vector<std::uint16_t> volume, int size);

}  // namespace hazer::render
