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
    glm::floatBitsToInt, glm::floor, glm::inversesqrt, glm::length, glm::log2, glm::max, glm::min,
    glm::normalize, glm::pow, glm::sin, glm::sqrt;

/// What the formulas ask of whoever includes them, where nothing stands in the light's way and the haze is
/// even. Derive from it to say otherwise.
template <typename Scalar>
struct EmptyAir {
    using Vector = glm::vec<3, Scalar>;
    bool hasProfileRule() const { return false; }
    glm::vec<4, Scalar> profileRule(Scalar) const { return glm::vec<4, Scalar>(0); }
    Vector shadePlace(const Vector& pointM) const { return pointM; }
    Scalar placeWeight(const Vector&) const { return 1; }
    bool placeSeesLamp(const Vector&) const { return true; }
    bool seesLamp(const Vector&) const { return true; }
    Scalar densityAt(Scalar) const { return 1; }
    Scalar densityAround(Scalar, Scalar) const { return 1; }
};

/// The shared formulas as members, in float or double. Members, so that what a program does not use costs
/// nothing. `Surroundings` answers what the formulas ask, see EmptyAir.
template <typename Scalar, typename Surroundings = EmptyAir<Scalar>>
struct Formulas : Surroundings {
    using Real = Scalar;
    using Real2 = glm::vec<2, Scalar>;
    using Real3 = glm::vec<3, Scalar>;
    using Real4 = glm::vec<4, Scalar>;
    using Surroundings::densityAt, Surroundings::densityAround, Surroundings::hasProfileRule,
        Surroundings::placeSeesLamp, Surroundings::placeWeight, Surroundings::profileRule,
        Surroundings::seesLamp, Surroundings::shadePlace;
    static constexpr Real PI = Real(3.14159265358979323846);
#include "shaders/include/aperture.glsl"
#include "shaders/include/beam_profile.glsl"
#include "shaders/include/beam_ray.glsl"
#include "shaders/include/gauss_legendre.glsl"
#include "shaders/include/haze_swirls.glsl"
#include "shaders/include/phase.glsl"
#include "shaders/include/shadow_frustum.glsl"
#include "shaders/include/surface_light.glsl"
    // Needs those above.
#include "shaders/include/beam_medium.glsl"
    // Gobos are tested through pictures.
    Real3 apertureAt(const LampSample&) const {
        return Real3(Real(1));
    }
#include "shaders/include/beam_arc.glsl"
#include "shaders/include/beam_density.glsl"
#include "shaders/include/beam_integral.glsl"
    // Needs that above.
#include "shaders/include/beam_backwards.glsl"
#include "shaders/include/beam_line.glsl"
#include "shaders/include/beam_line_filter.glsl"
#include "shaders/include/beam_reference.glsl"
#include "shaders/include/beam_shade.glsl"
};

}  // namespace hazer::render::glsl

#undef OUT
#undef INOUT
