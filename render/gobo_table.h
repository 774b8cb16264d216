// The table of line integrals through a gobo (shaders/include/gobo_table.glsl): Radon transform with Legendre
// moments. Pure CPU; takes some tenths of a second.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <vector>

#include <glm/glm.hpp>

#include "render/gobo_picture.h"
#include "render/scene.h"

namespace hazer::render {

/// A beam's profile on the gobo: what is in the table beside the gobo itself.
struct GoboProfile {
    double beamOverField = 1.0;  ///< Angle of 50 % over the field angle, (0, 1].
    double exponent = 0.0;       ///< Of the super-Gaussian, 1..12; 0: flat.
    auto operator<=>(const GoboProfile&) const = default;
};

/// What a table is of.
struct GoboTableKey {
    GoboId gobo = -1;
    GoboProfile profile;
    auto operator<=>(const GoboTableKey&) const = default;
};

/// Where a table lies among the layers on the GPU.
struct GoboTableSlot {
    int firstLayer = -1;  ///< -1: there is no table (yet); the shader takes taps.
    int layers = 0;       ///< 1: grey; 3: red, green, blue.
    bool operator==(const GoboTableSlot&) const = default;
};

/// Texels of a layer: shaders/include/gobo_table.glsl has the same numbers.
inline constexpr int kGoboTableWidth = 1156;
inline constexpr int kGoboTableHeight = 260;
inline constexpr std::size_t kGoboTableLayerHalves = std::size_t{4} * kGoboTableWidth * kGoboTableHeight;

struct GoboTable {
    int layers = 0;  ///< 1: grey; 3: red, green, blue. 0: stopped.
    /// Layer after layer, row after row, four 16-bit floats a texel.
    std::vector<std::uint16_t> halves;
};

/// Stops early, with an empty result, when asked to.
GoboTable buildGoboTable(const GoboPicture& picture, const GoboProfile& profile,
                         const std::stop_token& stop = {});

/// How a blur level of the table is sampled.
struct GoboLineGrid {
    int turns = 512;        ///< Directions of lines around the circle, a multiple of 4.
    int distances = 257;    ///< From the middle to the table's radius, both included; at least 2.
    int texelsPerCell = 1;  ///< The gobo is looked at every so many texels of its sharp picture.
};

/// M_0..M_3 of one colour channel (0..2) at one blur level, `distances` rows of `turns`. The values are such
/// that linear interpolation between them has the least mean error, not none at the nodes.
std::vector<glm::vec4> goboLineMoments(const GoboPicture& picture, int channel, int level,
                                       const GoboProfile& profile, const GoboLineGrid& grid,
                                       const std::stop_token& stop = {});

}  // namespace hazer::render
