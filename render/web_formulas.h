// Compiles shaders/include/web.glsl as C++, with the picture of a web to look at.
#pragma once

#include <cstddef>

#include "render/glsl_as_cpp.h"
#include "render/ies_web.h"

namespace hazer::render::glsl {

template <typename Scalar>
struct WebFormulas {
    using Real = Scalar;
    using Real2 = glm::vec<2, Scalar>;
    using Real3 = glm::vec<3, Scalar>;
    static constexpr Real PI = Real(3.14159265358979323846);

    const IesWeb& web;

    /// What a GPU's texture unit does: linear between the centres of texels, repeating in x, clamped in y.
    Real webTexel(Real2 place) const {
        const Real x = place.x * kWebAzimuths - Real(0.5);
        const Real y = clamp(place.y * kWebThetas - Real(0.5), Real(0), Real(kWebThetas - 1));
        const Real column = std::floor(x);
        const int row = min(static_cast<int>(y), kWebThetas - 2);
        const Real across = x - column;
        const Real down = y - Real(row);
        const auto texel = [&](int right, int below) {
            const int wrapped =
                ((static_cast<int>(column) + right) % kWebAzimuths + kWebAzimuths) % kWebAzimuths;
            const auto line = static_cast<std::size_t>(row + below);
            return Real(web.relative[line * kWebAzimuths + static_cast<std::size_t>(wrapped)]);
        };
        return (Real(1) - down) * ((Real(1) - across) * texel(0, 0) + across * texel(1, 0)) +
               down * ((Real(1) - across) * texel(0, 1) + across * texel(1, 1));
    }
#include "shaders/include/web.glsl"
};

}  // namespace hazer::render::glsl
