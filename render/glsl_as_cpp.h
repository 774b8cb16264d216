// Compiles shaders/include as C++, so that a formula is written once for the GPU, the CPU and the tests:
//     glsl::Formulas<double> formulas;
//     formulas.phaseHenyeyGreenstein(1.0, 0.7);
#pragma once

#include <glm/glm.hpp>

#define OUT(T) T&
#define INOUT(T) T&

namespace hazer::render::glsl {

// GLSL's built-ins under their own names.
using glm::abs, glm::atan, glm::ceil, glm::clamp, glm::cos, glm::cross, glm::dot, glm::exp, glm::exp2,
    glm::length, glm::max, glm::min, glm::normalize, glm::pow, glm::sin, glm::sqrt;

/// The shared formulas as members, in float or double. Members, so that what a program does not use costs
/// nothing.
template <typename Scalar>
struct Formulas {
    using Real = Scalar;
    using Real2 = glm::vec<2, Scalar>;
    using Real3 = glm::vec<3, Scalar>;
    static constexpr Real PI = Real(3.14159265358979323846);
#include "shaders/include/beam_profile.glsl"
#include "shaders/include/beam_ray.glsl"
#include "shaders/include/gauss_legendre.glsl"
#include "shaders/include/phase.glsl"
#include "shaders/include/shadow_frustum.glsl"
    // Needs those above.
#include "shaders/include/beam_medium.glsl"
    // The hooks of beam_integral.glsl: nothing in the way, even haze.
    Real3 transmissionAt(const LampSample&) {
        return Real3(Real(1));
    }
    Real densityAt(Real) {
        return Real(1);
    }
#include "shaders/include/beam_integral.glsl"
};

}  // namespace hazer::render::glsl

#undef OUT
#undef INOUT
