// The delta-Eddington haze: what is taken away, and what must stay.
#include "render/delta_eddington.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <vector>

#include "render/glsl_as_cpp.h"

namespace hazer::test {
namespace {

using render::Haze;

constexpr double kPi = 3.14159265358979323846;

/// Moments of the phase function as it is drawn: by P_l(mu) over the sphere, l = 0..2.
double moment(const Haze& haze, int order) {
    render::glsl::Formulas<double> f;
    boost::math::quadrature::tanh_sinh<double> integrator;
    return 2.0 * kPi *
           integrator.integrate(
               [&](double mu) {
                   const double legendre = order == 0 ? 1.0 : order == 1 ? mu : 0.5 * (3.0 * mu * mu - 1.0);
                   return legendre * f.phaseTwoLobes(mu, static_cast<double>(haze.phase.forwardG),
                                                     static_cast<double>(haze.phase.backwardG),
                                                     static_cast<double>(haze.phase.forwardWeight));
               },
               -1.0, 1.0);
}

Haze hazeOf(float extinction, float scattering, const render::PhaseFunction& phase) {
    Haze haze;
    haze.extinctionPerM = extinction;
    haze.scatteringPerM = scattering;
    haze.phase = phase;
    haze.deltaEddington = true;
    return haze;
}

/// Light, dark, thick, of one lobe, of two, of none that points forward.
std::vector<Haze> hazes() {
    return {hazeOf(0.01f, 0.01f, {}),
            hazeOf(0.5f, 0.4f, {0.95f, -0.2f, 0.9f}),
            hazeOf(0.1f, 0.1f, {0.7f, 0.7f, 1.0f}),
            hazeOf(0.1f, 0.02f, {0.3f, -0.9f, 0.5f}),
            hazeOf(0.03f, 0.03f, {0.0f, 0.0f, 1.0f}),
            hazeOf(0.03f, 0.03f, {-0.6f, -0.6f, 1.0f})};
}

double share(const Haze& before, const Haze& after) {
    return 1.0 - static_cast<double>(after.scatteringPerM) / static_cast<double>(before.scatteringPerM);
}

TEST(DeltaEddington, OffLeavesTheHazeAsItIs) {
    Haze haze = hazes().front();
    haze.deltaEddington = false;
    const Haze same = render::hazeToIntegrate(haze);
    EXPECT_EQ(same.extinctionPerM, haze.extinctionPerM);
    EXPECT_EQ(same.scatteringPerM, haze.scatteringPerM);
    EXPECT_EQ(same.phase.forwardG, haze.phase.forwardG);
    EXPECT_EQ(same.phase.forwardWeight, haze.phase.forwardWeight);
}

// Joseph, Wiscombe, Weinman 1976, for one lobe: f = g^2, g' = g / (1 + g).
TEST(DeltaEddington, OneLobeIsTheTextbooksCase) {
    const Haze after = render::hazeToIntegrate(hazeOf(0.2f, 0.1f, {0.8f, 0.8f, 1.0f}));
    EXPECT_NEAR(after.scatteringPerM, 0.1f * (1.0f - 0.64f), 1e-7f);
    EXPECT_NEAR(after.extinctionPerM, 0.2f - 0.064f, 1e-7f);
    EXPECT_NEAR(after.phase.forwardG, 0.8f / 1.8f, 1e-6f);
    EXPECT_FLOAT_EQ(after.phase.forwardWeight, 1.0f);
}

// The textbook's equations for the albedo w and the optical depth t: t' = (1 - w f) t, w' = (1 - f) w / (1 -
// w f).
TEST(DeltaEddington, AbsorptionStaysAndTheAlbedoFollows) {
    for (const Haze& before : hazes()) {
        const Haze after = render::hazeToIntegrate(before);
        const double f = share(before, after);
        const double extinction = static_cast<double>(before.extinctionPerM);
        const double albedo = static_cast<double>(before.scatteringPerM) / extinction;
        EXPECT_NEAR(static_cast<double>(after.extinctionPerM) - static_cast<double>(after.scatteringPerM),
                    extinction - static_cast<double>(before.scatteringPerM), 1e-6 * extinction);
        EXPECT_NEAR(static_cast<double>(after.extinctionPerM) / extinction, 1.0 - albedo * f, 1e-6);
        EXPECT_NEAR(static_cast<double>(after.scatteringPerM) / static_cast<double>(after.extinctionPerM),
                    (1.0 - f) * albedo / (1.0 - albedo * f), 1e-6);
    }
}

// Peak and remainder together have the moments of the whole: all of the light, and its mean cosine.
TEST(DeltaEddington, FirstMomentsAreKept) {
    for (const Haze& before : hazes()) {
        const Haze after = render::hazeToIntegrate(before);
        const double f = share(before, after);
        for (const int order : {0, 1}) {
            EXPECT_NEAR(f + (1.0 - f) * moment(after, order), moment(before, order), 1e-6) << order;
        }
        // Similarity relation: the transport coefficient scattering (1 - mean cosine) is the same.
        EXPECT_NEAR(static_cast<double>(after.scatteringPerM) * (1.0 - moment(after, 1)),
                    static_cast<double>(before.scatteringPerM) * (1.0 - moment(before, 1)),
                    1e-6 * static_cast<double>(before.scatteringPerM));
    }
}

// What goes straight on is the forward lobe's second moment.
TEST(DeltaEddington, ThePeakIsTheForwardLobesSecondMoment) {
    const Haze before = hazeOf(0.1f, 0.1f, {0.78f, -0.58f, 0.97f});
    Haze forward = before;
    forward.phase.forwardWeight = 1.0f;
    EXPECT_NEAR(share(before, render::hazeToIntegrate(before)), 0.97 * moment(forward, 2), 1e-6);
}

TEST(DeltaEddington, ALobeThatPointsBackHasNoPeak) {
    const Haze before = hazes().back();
    const Haze after = render::hazeToIntegrate(before);
    EXPECT_EQ(after.scatteringPerM, before.scatteringPerM);
    EXPECT_EQ(after.phase.forwardG, before.phase.forwardG);
}

// A show may ask for haze that scatters without extinction, for pictures of single scattering alone.
TEST(DeltaEddington, NoHazeGlowsByItself) {
    EXPECT_EQ(render::hazeToIntegrate(hazeOf(0.0f, 0.1f, {})).extinctionPerM, 0.0f);
}

}  // namespace
}  // namespace hazer::test
