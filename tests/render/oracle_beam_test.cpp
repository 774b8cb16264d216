// The oracle of one beam, against closed forms and against sums of very many samples.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "render/oracle/single_beam.h"

namespace hazer::test {
namespace {

using namespace render::oracle;

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadPerDeg = kPi / 180.0;

BeamModel flat(double halfAngleDeg) {
    BeamModel beam;
    beam.cutHalfAngleRad = halfAngleDeg * kRadPerDeg;
    beam.beamHalfAngleRad = beam.cutHalfAngleRad;
    return beam;
}

HazeModel isotropic(double scatteringPerM, double extinctionPerM) {
    return {extinctionPerM, scatteringPerM, 0.0, 0.0, 1.0};
}

/// A ray along X, `depthM` below the lamp.
Ray acrossBelow(double depthM, double fromM, double lengthM) {
    return {{fromM, 0.0, -depthM}, {1.0, 0.0, 0.0}, lengthM};
}

/// Isotropic haze without extinction: sigma I (u1 - u0) / (4 pi h).
double closedForm(double scatteringPerM, double u0, double u1, double distanceM) {
    return scatteringPerM * (u1 - u0) / (4.0 * kPi * distanceM);
}

TEST(OracleBeam, acrossTheWholeBeamIsTheClosedForm) {
    for (const double halfDeg : {0.01, 0.5, 12.0, 60.0, 89.0}) {
        const double reach = 3.0 * std::tan(halfDeg * kRadPerDeg) + 1.0;
        const double got =
            airRadiance(flat(halfDeg), isotropic(0.02, 0.0), acrossBelow(3.0, -reach, 2.0 * reach));
        const double expected = closedForm(0.02, -halfDeg * kRadPerDeg, halfDeg * kRadPerDeg, 3.0);
        EXPECT_NEAR(got / expected, 1.0, 1e-7) << halfDeg;
    }
}

TEST(OracleBeam, aRayThatEndsInsideIsTheClosedForm) {
    const double got = airRadiance(flat(30.0), isotropic(0.02, 0.0), acrossBelow(3.0, 0.5, 0.7));
    EXPECT_NEAR(got / closedForm(0.02, std::atan(0.5 / 3.0), std::atan(1.2 / 3.0), 3.0), 1.0, 1e-9);
}

TEST(OracleBeam, twoConesThatFillTheSphereAreAPointSource) {
    const HazeModel haze = isotropic(0.02, 0.0);
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 50; ++i) {
        Ray ray{{normal(random), normal(random), normal(random)}, {0.0, 0.0, 1.0}, 7.0};
        ray.direction = glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
        Ray mirrored = ray;
        mirrored.originM.z = -ray.originM.z;
        mirrored.direction.z = -ray.direction.z;
        const double halfDeg = 91.0 + i;
        const double sum =
            airRadiance(flat(halfDeg), haze, ray) + airRadiance(flat(180.0 - halfDeg), haze, mirrored);
        const double closest = -glm::dot(ray.originM, ray.direction);
        const double distance = glm::length(ray.originM + closest * ray.direction);
        const double expected = closedForm(0.02, std::atan(-closest / distance),
                                           std::atan((ray.endM - closest) / distance), distance);
        EXPECT_NEAR(sum / expected, 1.0, 1e-7) << halfDeg;
    }
}

/// The integral straight from its definition: many even steps.
double bruteForce(const BeamModel& beam, const HazeModel& haze, const Ray& ray, int steps) {
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double t = (i + 0.5) * ray.endM / steps;
        const glm::dvec3 p = ray.originM + t * ray.direction;
        const double depth = -p.z;
        const double psi = std::acos(depth / glm::length(p));
        if (psi > beam.cutHalfAngleRad || depth < beam.apexToLensM) continue;
        const double soft =
            (std::exp2(-std::pow(psi / beam.beamHalfAngleRad, beam.exponent)) - beam.profileCut) /
            (1.0 - beam.profileCut);
        const double travelled = t + glm::length(p) - beam.apexToLensM / std::cos(psi);
        const double cosine = -glm::dot(glm::normalize(p), ray.direction);
        const auto lobe = [&](double g) {
            return (1.0 - g * g) / (4.0 * kPi * std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5));
        };
        sum +=
            (haze.forwardWeight * lobe(haze.forwardG) + (1.0 - haze.forwardWeight) * lobe(haze.backwardG)) *
            std::max(soft, 0.0) * std::exp(-haze.extinctionPerM * travelled) / glm::dot(p, p);
    }
    return haze.scatteringPerM * sum * ray.endM / steps;
}

TEST(OracleBeam, softBeamsAreTheSumOfManySamples) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    const HazeModel haze{0.08, 0.05, 0.78, -0.58, 0.97};
    int lit = 0;
    for (int i = 0; i < 20; ++i) {
        BeamModel beam{0.4, 0.25, 2.5, 0.005, 0.3};
        const glm::dvec3 target(0.5 * share(random), 0.3 * share(random), -1.0 - 5.0 * share(random));
        const glm::dvec3 eye(8.0 * share(random) - 4.0, -6.0 * share(random), -8.0 * share(random));
        const Ray ray{eye, glm::normalize(target - eye), 12.0};
        const double expected = bruteForce(beam, haze, ray, 400000);
        if (expected <= 0.0) continue;
        ++lit;
        EXPECT_NEAR(airRadiance(beam, haze, ray) / expected, 1.0, 2e-5) << "ray " << i;
    }
    EXPECT_GT(lit, 10);
}

TEST(OracleBeam, opticalDepthOfTwenty) {
    const HazeModel haze{5.0, 5.0, 0.78, -0.58, 0.97};
    const Ray ray{{-4.0, 0.0, -3.0}, {1.0, 0.0, 0.0}, 8.0};
    BeamModel beam = flat(40.0);
    beam.exponent = 1e-9;  // brute force knows the soft profile only: 2^-1 everywhere
    const double half = bruteForce(beam, haze, ray, 2000000);
    EXPECT_NEAR(airRadiance(beam, haze, ray) / half, 1.0, 1e-4);
}

TEST(OracleBeam, transmissionMultipliesAndShadowLeavesOut) {
    const HazeModel haze = isotropic(0.02, 0.0);
    const Ray ray = acrossBelow(3.0, -5.0, 10.0);
    const BeamModel beam = flat(30.0);
    const std::vector<Stretch> smooth = smoothStretches(beam, ray);
    const double whole = airRadiance(beam, haze, ray);
    EXPECT_NEAR(airRadiance(beam, haze, ray, smooth, [](double) { return 0.25; }) / whole, 0.25, 1e-6);
    // Half the beam, cut at its axis.
    std::vector<Stretch> half;
    for (Stretch stretch : smooth) {
        stretch.toM = std::min(stretch.toM, 5.0);
        if (stretch.toM > stretch.fromM) half.push_back(stretch);
    }
    EXPECT_NEAR(airRadiance(beam, haze, ray, half, [](double) { return 1.0; }) / whole, 0.5, 1e-6);
}

TEST(OracleBeam, partsOfAStretchFillIt) {
    const Ray ray{{-3.0, 0.2, -0.1}, {1.0, 0.0, 0.0}, 1e5};
    for (const Stretch& stretch : {Stretch{0.0, 1e5}, Stretch{2.9, 3.1}, Stretch{4.0, 5.0}}) {
        const std::vector<Stretch> parts = splitByAngle(ray, stretch, 50);
        ASSERT_FALSE(parts.empty());
        EXPECT_EQ(parts.front().fromM, stretch.fromM);
        EXPECT_EQ(parts.back().toM, stretch.toM);
        for (std::size_t i = 1; i < parts.size(); ++i) EXPECT_EQ(parts[i].fromM, parts[i - 1].toM);
    }
}

}  // namespace
}  // namespace hazer::test
