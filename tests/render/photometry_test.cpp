// Lumens in, candelas out: every profile integrates to its flux, and known lamps come out right.
#include "render/photometry.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>

namespace hazer::test {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadPerDeg = kPi / 180.0;

render::Beam lamp(double beamDeg, double fieldDeg, double fluxLm,
                  render::BeamEdge edge = render::BeamEdge::kSoft) {
    render::Beam beam;
    beam.beamAngleRad = beamDeg * kRadPerDeg;
    beam.fieldAngleRad = fieldDeg * kRadPerDeg;
    beam.fluxLm = fluxLm;
    beam.edge = edge;
    return beam;
}

/// Flux of a shape by adaptive quadrature over the sphere, in double.
double integratedFlux(const render::BeamShape& shape) {
    boost::math::quadrature::tanh_sinh<double> integrator;
    const auto ring = [&](double psi) {
        return shape.peakCd * render::relativeIntensity(shape, psi) * 2.0 * kPi * std::sin(psi);
    };
    return integrator.integrate(ring, 0.0, shape.cutHalfAngleRad * (1.0 - 1e-12));
}

TEST(Photometry, IntensityIntegratesToTheFlux) {
    for (const double field : {0.1, 2.0, 15.0, 45.0, 90.0, 150.0, 200.0, 300.0, 358.0}) {
        for (const double share : {0.3, 0.6, 0.9, 1.0}) {
            const render::BeamShape shape = render::beamShape(lamp(share * field, field, 10000.0));
            EXPECT_NEAR(integratedFlux(shape), 10000.0, 1.0)
                << "field " << field << ", beam " << share * field;
        }
    }
}

// 10 000 lm spread evenly over a cone of 20 degrees: solid angle 2 pi (1 - cos 10 deg) = 0.09546 sr.
TEST(Photometry, TenThousandLumensOverTwentyDegrees) {
    const render::BeamShape shape = render::beamShape(lamp(20.0, 20.0, 10000.0, render::BeamEdge::kFlat));
    EXPECT_NEAR(shape.peakCd, 104760.0, 10.0);
}

TEST(Photometry, HalfAtTheBeamAngleAndATenthAtTheFieldAngle) {
    const render::BeamShape shape = render::beamShape(lamp(12.0, 15.0, 10000.0));
    // The pedestal of half a percent shifts both a little.
    EXPECT_NEAR(render::relativeIntensity(shape, 6.0 * kRadPerDeg), 0.5, 0.005);
    EXPECT_NEAR(render::relativeIntensity(shape, 7.5 * kRadPerDeg), 0.1, 0.005);
    EXPECT_EQ(render::relativeIntensity(shape, shape.cutHalfAngleRad), 0.0);
    EXPECT_NEAR(shape.peakCd, 285000.0,
                285000.0 * 0.01);  // closed form: flux (ln 2)^(2/p) / (pi tb^2 gamma(1 + 2/p))
}

TEST(Photometry, TheApexLiesWhereTheConeIsAsWideAsTheLens) {
    render::Beam beam = lamp(3.0, 3.8, 1.0);
    beam.lensRadiusM = 0.085;
    EXPECT_NEAR(render::beamShape(beam).apexToLensM, 0.085 / std::tan(1.9 * kRadPerDeg), 1e-12);
}

// A candela all around is 4 pi lumen; a cone of 179 degrees lacks 2 pi (1 - cos 1 deg) of it.
TEST(Photometry, AlmostAllOfTheSphere) {
    const double solidAngleSr = 2.0 * kPi * (1.0 + std::cos(kRadPerDeg));
    const render::BeamShape shape = render::beamShape(lamp(358.0, 358.0, 1000.0, render::BeamEdge::kFlat));
    EXPECT_NEAR(shape.peakCd, 1000.0 / solidAngleSr, 1e-9);
}

// A lamp that opens beyond a half space has no lens plane, and gets there without a jump.
TEST(Photometry, ShapesChangeSteadilyWithTheAngle) {
    render::Beam beam = lamp(0.0, 0.0, 1000.0);
    beam.lensRadiusM = 0.1;
    for (const render::BeamEdge edge : {render::BeamEdge::kFlat, render::BeamEdge::kSoft}) {
        beam.edge = edge;
        render::BeamShape before;
        for (double halfDeg = 88.5; halfDeg < 91.5; halfDeg += 0.001) {
            beam.fieldAngleRad = 2.0 * halfDeg * kRadPerDeg;
            beam.beamAngleRad = 0.7 * beam.fieldAngleRad;
            const render::BeamShape shape = render::beamShape(beam);
            if (halfDeg > 88.5) {
                EXPECT_NEAR(shape.apexToLensM, before.apexToLensM, 1e-5) << halfDeg;
                EXPECT_NEAR(shape.cutHalfAngleRad, before.cutHalfAngleRad, 3e-3) << halfDeg;
                EXPECT_NEAR(shape.peakCd, before.peakCd, 1e-3 * before.peakCd) << halfDeg;
            }
            EXPECT_TRUE(shape.apexToLensM == 0.0 || shape.cutHalfAngleRad < 0.5 * kPi) << halfDeg;
            before = shape;
        }
        EXPECT_EQ(before.apexToLensM, 0.0);
    }
}

TEST(Photometry, AnglesOutOfRangeAreTakenIn) {
    for (const double field : {-5.0, 0.0, 1e-9, 180.0, 400.0}) {
        const render::BeamShape shape = render::beamShape(lamp(500.0, field, 1000.0));
        EXPECT_TRUE(std::isfinite(shape.peakCd));
        EXPECT_GT(shape.peakCd, 0.0);
        EXPECT_LE(shape.cutHalfAngleRad, 179.0 * kRadPerDeg + 1e-12);
    }
    render::Beam beam = lamp(300.0, 300.0, 1000.0);
    beam.gobo = 0;
    EXPECT_LE(render::beamShape(beam).cutHalfAngleRad, 89.5 * kRadPerDeg);
    EXPECT_EQ(render::beamShape(lamp(10.0, 20.0, -1.0)).peakCd, 0.0);
}

}  // namespace
}  // namespace hazer::test
