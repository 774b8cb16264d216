// The beam integral of shaders/include, compiled as C++, against the oracle.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "render/glsl_as_cpp.h"
#include "render/oracle/single_beam.h"
#include "render/photometry.h"

namespace hazer::test {
namespace {

constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;

struct Ray {
    render::oracle::BeamModel beam;
    render::oracle::HazeModel haze;
    glm::dvec3 eye{0.0};
    glm::dvec3 direction{0.0};
    double endM = 50.0;
};

glm::dvec3 randomDirection(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
}

/// Looks at a random point inside the beam, from anywhere: outside, inside, behind the lamp, into the lens.
Ray randomRay(std::mt19937& random, bool soft) {
    const auto between = [&](double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(random);
    };
    Ray ray;
    render::Beam beam;
    beam.fieldAngleRad = 2.0 * between(0.5, 60.0) * kRadPerDeg;
    beam.beamAngleRad = soft ? beam.fieldAngleRad * between(0.4, 0.9) : beam.fieldAngleRad;
    beam.lensRadiusM = between(0.01, 0.15);
    const render::BeamShape shape = render::beamShape(beam);
    ray.beam = {shape.cutHalfAngleRad, shape.beamHalfAngleRad, shape.exponent,
                render::glsl::Formulas<double>().PROFILE_CUT, shape.apexToLensM};
    ray.haze.extinctionPerM = between(0.0, 0.1);
    ray.haze.scatteringPerM = ray.haze.extinctionPerM + 0.001;
    const double psi = between(0.0, 0.95) * shape.fieldHalfAngleRad;
    const double around = between(0.0, 360.0) * kRadPerDeg;
    const glm::dvec3 inBeam(std::sin(psi) * std::cos(around), std::sin(psi) * std::sin(around),
                            -std::cos(psi));
    const glm::dvec3 target = inBeam * (shape.apexToLensM / std::cos(psi) + between(0.5, 25.0));
    const double distance = between(0.5, 40.0);
    ray.direction = randomDirection(random);
    ray.eye = target - distance * ray.direction;
    ray.endM = distance + between(0.0, 40.0);
    return ray;
}

/// The shared formulas set up for a ray.
template <typename Scalar>
struct Shader : render::glsl::Formulas<Scalar> {
    using Formulas = render::glsl::Formulas<Scalar>;
    using Vector = typename Formulas::Real3;
    static Scalar scalar(double value) { return static_cast<Scalar>(value); }

    explicit Shader(const Ray& from)
        : ray(this->lampRay(Vector(from.eye), glm::normalize(Vector(from.direction)), Vector(0, 0, -1))),
          optics{scalar(std::cos(from.beam.cutHalfAngleRad)), scalar(std::sin(from.beam.cutHalfAngleRad)),
                 scalar(from.beam.apexToLensM), scalar(from.beam.beamHalfAngleRad),
                 scalar(from.beam.exponent)},
          haze{scalar(from.haze.extinctionPerM), scalar(from.haze.scatteringPerM), scalar(from.haze.forwardG),
               scalar(from.haze.backwardG), scalar(from.haze.forwardWeight)} {}

    typename Formulas::LampRay ray;
    typename Formulas::BeamOptics optics;
    typename Formulas::HazeMedium haze;
};

template <typename Scalar>
double radiance(const Ray& ray, int pieces) {
    Shader<Scalar> shader(ray);
    return static_cast<double>(shader
                                   .beamInAir(shader.ray, shader.optics, shader.haze, shader.scalar(ray.endM),
                                              static_cast<Scalar>(pieces))
                                   .x);
}

double uniformRadiance(const Ray& ray, int samples) {
    Shader<double> shader(ray);
    return shader.beamInAirUniform(shader.ray, shader.optics, shader.haze, ray.endM, samples).x;
}

/// Relative errors of `count` random rays, sorted.
template <typename Scalar>
std::vector<double> errors(int count, bool soft, int pieces) {
    std::mt19937 random(7);
    std::vector<double> found;
    while (static_cast<int>(found.size()) < count) {
        const Ray ray = randomRay(random, soft);
        const double expected =
            render::oracle::airRadiance(ray.beam, ray.haze, {ray.eye, ray.direction, ray.endM});
        if (expected < 1e-12) continue;
        const double got = radiance<Scalar>(ray, pieces);
        EXPECT_TRUE(std::isfinite(got));
        found.push_back(std::abs(got - expected) / expected);
    }
    std::sort(found.begin(), found.end());
    return found;
}

double quantile(const std::vector<double>& sorted, double share) {
    return sorted[std::min(sorted.size() - 1,
                           static_cast<std::size_t>(share * static_cast<double>(sorted.size())))];
}

void report(const std::string& what, const std::vector<double>& sorted) {
    fmt::print("{}: median {:.1e}, 99 % {:.1e}, 99.9 % {:.1e}, worst {:.1e}\n", what, quantile(sorted, 0.5),
               quantile(sorted, 0.99), quantile(sorted, 0.999), sorted.back());
}

TEST(BeamIntegral, FlatBeamKeepsOneInAThousandWithFourNodesAPiece) {
    const std::vector<double> inFloat = errors<float>(10000, false, 1);
    report("flat, float", inFloat);
    EXPECT_LT(quantile(inFloat, 0.999), 1e-3);
    const std::vector<double> inDouble = errors<double>(2000, false, 1);
    report("flat, double", inDouble);
    EXPECT_LT(quantile(inDouble, 0.999), 1e-3);
}

// A steep soft edge is not a polynomial: what eight nodes leave over is stated here, and must vanish as nodes
// are added.
TEST(BeamIntegral, SoftBeamConvergesWithPieces) {
    const std::vector<double> asDrawn = errors<float>(10000, true, 3);
    report("soft, 12 nodes", asDrawn);
    EXPECT_LT(quantile(asDrawn, 0.5), 1e-3);
    EXPECT_LT(quantile(asDrawn, 0.99), 3e-2);
    const std::vector<double> fine = errors<double>(2000, true, 32);
    report("soft, 128 nodes, double", fine);
    EXPECT_LT(fine.back(), 5e-5);  // thick haze is cut at 1e-5 of its start
}

// The thesis' method on the same rays: kept as the baseline of every report.
TEST(BeamIntegral, UniformSamplesConvergeToTheSameRadiance) {
    std::mt19937 random(11);
    for (int i = 0; i < 20; ++i) {
        const Ray ray = randomRay(random, true);
        const double expected = radiance<double>(ray, 16);
        if (expected < 1e-9) continue;
        EXPECT_NEAR(uniformRadiance(ray, 400000) / expected, 1.0, 2e-2);
    }
}

}  // namespace
}  // namespace hazer::test
