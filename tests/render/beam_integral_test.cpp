// The beam integral of shaders/include, compiled as C++, against the oracle.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "tests/render/beam_ways.h"

namespace hazer::test {
namespace {

constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;

glm::dvec3 randomDirection(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
}

double between(std::mt19937& random, double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
}

/// Looks at a random point inside a beam, from anywhere: outside, inside, behind the lamp, into the lens.
BeamView randomView(std::mt19937& random, const render::Beam& beam) {
    BeamView view;
    view.shape = render::beamShape(beam);
    view.beam = modelOf(view.shape);
    view.haze.extinctionPerM = between(random, 0.0, 0.1);
    view.haze.scatteringPerM = view.haze.extinctionPerM + 0.001;
    const double psi = between(random, 0.0, 0.95) * view.shape.fieldHalfAngleRad;
    const double around = between(random, 0.0, 360.0) * kRadPerDeg;
    const glm::dvec3 inBeam(std::sin(psi) * std::cos(around), std::sin(psi) * std::sin(around),
                            -std::cos(psi));
    const glm::dvec3 target = inBeam * (view.shape.apexToLensM / std::cos(psi) + between(random, 0.5, 25.0));
    const double distance = between(random, 0.5, 40.0);
    view.ray.direction = randomDirection(random);
    // The shaders know floats: the oracle looks along the same ray as they do.
    view.ray.originM = glm::dvec3(glm::vec3(target - distance * view.ray.direction));
    view.ray.direction = glm::normalize(glm::dvec3(glm::vec3(view.ray.direction)));
    view.ray.endM = distance + between(random, 0.0, 40.0);
    return view;
}

render::Beam beamOf(double halfAngleDeg, double beamOverField, double lensRadiusM) {
    render::Beam beam;
    beam.edge = beamOverField < 1.0 ? render::BeamEdge::kSoft : render::BeamEdge::kFlat;
    beam.fieldAngleRad = 2.0 * halfAngleDeg * kRadPerDeg;
    beam.beamAngleRad = beamOverField * beam.fieldAngleRad;
    beam.lensRadiusM = lensRadiusM;
    return beam;
}

/// Any half angle from half a degree to 60 degrees.
render::Beam randomBeam(std::mt19937& random, bool soft) {
    return beamOf(between(random, 0.5, 60.0), soft ? between(random, 0.4, 0.9) : 1.0,
                  between(random, 0.01, 0.15));
}

/// Relative errors, sorted.
class Errors {
 public:
    void add(double got, double expected) {
        EXPECT_TRUE(std::isfinite(got));
        errors_.push_back(std::abs(got - expected) / expected);
    }

    double quantile(double share) {
        std::sort(errors_.begin(), errors_.end());
        return errors_[std::min(errors_.size() - 1,
                                static_cast<std::size_t>(share * static_cast<double>(errors_.size())))];
    }

    void report(const std::string& what) {
        fmt::print("{}: median {:.1e}, 99 % {:.1e}, 99.9 % {:.1e}, worst {:.1e}\n", what, quantile(0.5),
                   quantile(0.99), quantile(0.999), quantile(1.0));
    }

    std::size_t count() const { return errors_.size(); }

 private:
    std::vector<double> errors_;
};

/// `makeBeam(random)` gives the beam of each view, `look(view)` its radiance in question.
template <typename MakeBeam, typename Look>
Errors errorsOf(int count, MakeBeam makeBeam, Look look) {
    std::mt19937 random(7);
    Errors errors;
    while (static_cast<int>(errors.count()) < count) {
        const BeamView view = randomView(random, makeBeam(random));
        const double expected = render::oracle::airRadiance(view.beam, view.haze, view.ray);
        if (expected > 1e-12) errors.add(look(view), expected);
    }
    return errors;
}

template <typename Scalar>
Errors errorsAsDrawn(int count, bool soft) {
    return errorsOf(
        count, [soft](std::mt19937& random) { return randomBeam(random, soft); },
        [](const BeamView& view) { return BeamFormulas<Scalar>(view).radiance(); });
}

void expectOneInAThousand(const std::string& profile, bool soft) {
    Errors inFloat = errorsAsDrawn<float>(10000, soft);
    inFloat.report(profile + ", float");
    EXPECT_LT(inFloat.quantile(0.999), 1e-3);
    Errors inDouble = errorsAsDrawn<double>(5000, soft);
    inDouble.report(profile + ", double");
    EXPECT_LT(inDouble.quantile(0.999), 1e-3);
}

TEST(BeamIntegral, FlatBeamKeepsOneInAThousand) {
    expectOneInAThousand("flat", false);
}

TEST(BeamIntegral, SoftBeamKeepsOneInAThousand) {
    expectOneInAThousand("soft", true);
}

TEST(BeamIntegral, HalfAnglesOfEverySize) {
    for (const double halfAngleDeg : {0.05, 0.5, 5.0, 45.0, 85.0}) {
        for (const double beamOverField : {1.0, 0.7}) {
            const auto beam = [&](std::mt19937&) { return beamOf(halfAngleDeg, beamOverField, 0.05); };
            Errors errors = errorsOf(
                3000, beam, [](const BeamView& view) { return BeamFormulas<float>(view).radiance(); });
            errors.report(fmt::format("{} degrees, {}", halfAngleDeg, beamOverField < 1.0 ? "soft" : "flat"));
            EXPECT_LT(errors.quantile(0.999), 1e-3);
        }
    }
}

// A lamp that shines backwards, too, may light a ray twice: before its dark cone and behind it.
TEST(BeamIntegral, HalfAnglesAboveNinetyDegrees) {
    for (const double halfAngleDeg : {90.1, 95.0, 120.0, 150.0, 170.0, 179.0}) {
        for (const double beamOverField : {1.0, 0.7, 0.4}) {
            const auto beam = [&](std::mt19937&) { return beamOf(halfAngleDeg, beamOverField, 0.05); };
            Errors errors = errorsOf(
                3000, beam, [](const BeamView& view) { return BeamFormulas<float>(view).radiance(); });
            errors.report(fmt::format("{} degrees, beam / field {}", halfAngleDeg, beamOverField));
            EXPECT_LT(errors.quantile(0.5), 1e-4);
            EXPECT_LT(errors.quantile(0.999), 1e-3);
        }
    }
}

// Nodes by number are the reference of reports: they must come as near as the thick haze's cut at 1e-5 lets
// them.
TEST(BeamIntegral, NodesByNumberConverge) {
    Errors errors = errorsOf(
        2000, [](std::mt19937& random) { return randomBeam(random, true); },
        [](const BeamView& view) { return BeamFormulas<double>(view).sampledRadiance(512); });
    errors.report("soft, 512 nodes, double");
    EXPECT_LT(errors.quantile(1.0), 5e-5);
}

// The thesis' method on the same rays: kept as the baseline of every report.
TEST(BeamIntegral, UniformSamplesConvergeToTheSameRadiance) {
    std::mt19937 random(11);
    for (int i = 0; i < 20; ++i) {
        const BeamView view = randomView(random, randomBeam(random, true));
        BeamFormulas<double> formulas(view);
        const double expected = formulas.sampledRadiance(128);
        if (expected < 1e-9) continue;
        const double uniform =
            formulas
                .beamInAirUniform(formulas.lampView, formulas.optics, formulas.haze, formulas.endM, 400000)
                .x;
        EXPECT_NEAR(uniform / expected, 1.0, 2e-2);
    }
}

TEST(BeamIntegral, UniformSamplesSeeLampsThatShineBackwards) {
    std::mt19937 random(12);
    int lit = 0;
    for (int i = 0; i < 20; ++i) {
        const BeamView view = randomView(random, beamOf(100.0 + 4.0 * i, i % 2 == 0 ? 1.0 : 0.6, 0.05));
        BeamFormulas<double> formulas(view);
        const double expected = render::oracle::airRadiance(view.beam, view.haze, view.ray);
        if (expected < 1e-9 || formulas.lampView.h < 0.1) continue;
        ++lit;
        const double uniform =
            formulas
                .beamInAirUniform(formulas.lampView, formulas.optics, formulas.haze, formulas.endM, 100000)
                .x;
        EXPECT_NEAR(uniform / expected, 1.0, 1e-3);
    }
    EXPECT_GT(lit, 10);
}

}  // namespace
}  // namespace hazer::test
