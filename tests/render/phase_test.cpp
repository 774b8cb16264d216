// Phase functions of shaders/include, compiled as C++: they neither make nor lose light, and g is the mean
// cosine.
#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>

#include "render/glsl_as_cpp.h"

namespace hazer::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

template <typename F>
double overSphere(F f) {
    boost::math::quadrature::tanh_sinh<double> integrator;
    return 2.0 * kPi * integrator.integrate(f, -1.0, 1.0);
}

TEST(Phase, HenyeyGreensteinIntegratesToOneWithMeanCosineG) {
    render::glsl::Formulas<double> f;
    for (const double g : {-0.9, -0.58, 0.0, 0.3, 0.78, 0.95}) {
        EXPECT_NEAR(overSphere([&](double mu) { return f.phaseHenyeyGreenstein(mu, g); }), 1.0, 1e-8);
        EXPECT_NEAR(overSphere([&](double mu) { return mu * f.phaseHenyeyGreenstein(mu, g); }), g, 1e-8);
    }
}

TEST(Phase, IsotropicIsOneOverFourPi) {
    EXPECT_NEAR(static_cast<double>(render::glsl::Formulas<float>().phaseHenyeyGreenstein(0.3f, 0.0f)),
                1.0 / (4.0 * kPi), 1e-8);
}

TEST(Phase, TwoLobesIntegrateToOneAndScatterForward) {
    render::glsl::Formulas<double> f;
    const auto phase = [&](double mu) { return f.phaseTwoLobes(mu, 0.78, -0.58, 0.97); };
    EXPECT_NEAR(overSphere(phase), 1.0, 1e-8);
    // Glycol haze of 0.8 um by Mie theory: 0.30 /sr at 30 degrees, 0.013 at 90; two lobes fit it to about a
    // factor of 1.2.
    EXPECT_NEAR(phase(std::cos(kPi / 6.0)) / 0.30, 1.0, 0.35);
    EXPECT_NEAR(phase(0.0) / 0.013, 1.0, 0.35);
}

}  // namespace
}  // namespace hazer::test
