// Compiles shaders/include/gobo_table.glsl as C++, with a table to look at.
#pragma once

#include <algorithm>
#include <cstddef>
#include <glm/gtc/packing.hpp>

#include "render/glsl_as_cpp.h"
#include "render/gobo_table.h"

#define OUT(T) T&
#define INOUT(T) T&

namespace hazer::render::glsl {

template <typename Scalar>
struct GoboTableFormulas {
    using Real = Scalar;
    using Real2 = glm::vec<2, Scalar>;
    using Real3 = glm::vec<3, Scalar>;
    using Real4 = glm::vec<4, Scalar>;
    static constexpr Real PI = Real(3.14159265358979323846);

    const GoboTable* table = nullptr;  ///< Only needed by what looks moments up.

    /// What a GPU's texture unit does: linear between the centres of texels, clamped.
    Real4 goboTableTexel(Real2 place, Real layer) const {
        const auto clamped = [](Real at, int size) { return clamp(at - Real(0.5), Real(0), Real(size - 1)); };
        const Real x = clamped(place.x, GOBO_TABLE_WIDTH);
        const Real y = clamped(place.y, GOBO_TABLE_HEIGHT);
        const int column = std::min(static_cast<int>(x), GOBO_TABLE_WIDTH - 2);
        const int row = std::min(static_cast<int>(y), GOBO_TABLE_HEIGHT - 2);
        const auto texel = [&](int right, int below) {
            const int index = (static_cast<int>(layer) * GOBO_TABLE_HEIGHT + row + below) * GOBO_TABLE_WIDTH +
                              column + right;
            const std::uint16_t* halves = &table->halves[4 * static_cast<std::size_t>(index)];
            Real4 value;
            for (int k = 0; k < 4; ++k) value[k] = Real(glm::unpackHalf1x16(halves[k]));
            return value;
        };
        const Real across = x - Real(column);
        const Real down = y - Real(row);
        return (Real(1) - down) * ((Real(1) - across) * texel(0, 0) + across * texel(1, 0)) +
               down * ((Real(1) - across) * texel(0, 1) + across * texel(1, 1));
    }

#include "shaders/include/beam_profile.glsl"
#include "shaders/include/beam_ray.glsl"
#include "shaders/include/gauss_legendre.glsl"
#include "shaders/include/phase.glsl"
    // Needs those above.
#include "shaders/include/beam_medium.glsl"
    // Needs that, too.
#include "shaders/include/gobo_table.glsl"
};

}  // namespace hazer::render::glsl

#undef OUT
#undef INOUT
