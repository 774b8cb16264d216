// What surfaces reflect: no more than arrives, the same both ways, and nothing but the albedo where nothing
// glosses.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <random>

#include "render/glsl_as_cpp.h"

namespace hazer::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

struct Material {
    double albedo = 1.0;
    double specular = 0.04;
    double shininess = 32.0;
};

/// Reflectance distribution [1/sr] for unit directions above the surface z = 0.
double reflectance(const Material& material, const glm::dvec3& in, const glm::dvec3& out) {
    const glm::dvec3 halfway = glm::normalize(in + out);
    double diffuse = 0.0, glossy = 0.0;
    render::glsl::Formulas<double>().surfaceReflection(in.z, out.z, halfway.z, glm::dot(halfway, in),
                                                       material.specular, material.shininess, diffuse,
                                                       glossy);
    return material.albedo * diffuse + glossy;
}

glm::dvec3 direction(double cosine, double azimuth) {
    const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
    return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

/// Light that leaves towards `out` under a sky of radiance 1: the integral of f cosIn over the hemisphere.
/// The sky is divided about the mirror's direction, where a sharp lobe stands: rings in the angle from the
/// half vector.
double underAnEvenSky(const Material& material, const glm::dvec3& out) {
    constexpr int kRings = 600, kSpokes = 240;
    double sum = 0.0;
    for (int ring = 0; ring < kRings; ++ring) {
        // Half vectors are spread so that narrow lobes have as many as wide ones: theta = (pi / 2) x^3.
        const double x = (ring + 0.5) / kRings;
        const double theta = 0.5 * kPi * x * x * x;
        const double thetaStep = 0.5 * kPi * 3.0 * x * x / kRings;
        for (int spoke = 0; spoke < kSpokes; ++spoke) {
            const double azimuth = 2.0 * kPi * (spoke + 0.5) / kSpokes;
            const glm::dvec3 halfway = direction(std::cos(theta), azimuth);
            const double cosApart = glm::dot(halfway, out);
            const glm::dvec3 in = 2.0 * cosApart * halfway - out;
            if (cosApart <= 0.0 || in.z <= 0.0) continue;
            // Solid angle of the light from that of the half vector: 4 cosApart.
            const double solidAngle = std::sin(theta) * thetaStep * (2.0 * kPi / kSpokes) * 4.0 * cosApart;
            sum += reflectance(material, in, out) * in.z * solidAngle;
        }
    }
    return sum;
}

TEST(SurfaceLight, ReflectsNoMoreThanArrives) {
    double most = 0.0;
    for (const double shininess : {1.0, 4.0, 16.0, 32.0, 128.0, 1000.0}) {
        for (const double specular : {0.0, 0.005, 0.02, 0.04, 0.15, 0.5, 1.0}) {
            for (const double cosOut : {0.02, 0.1, 0.25, 0.5, 0.75, 1.0}) {
                const double share = underAnEvenSky({1.0, specular, shininess}, direction(cosOut, 0.0));
                EXPECT_LE(share, 1.003)
                    << "shininess " << shininess << ", specular " << specular << ", cosine " << cosOut;
                most = std::max(most, share);
            }
        }
    }
    fmt::print("at most {:.4f} of the light leaves\n", most);
}

// The quadrature of the test above, on what is known: an even diffuser reflects its albedo, in every
// direction.
TEST(SurfaceLight, WithoutSpecularExactlyTheAlbedoIsLeft) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> unit(0.01, 1.0);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 in = direction(unit(random), 6.0 * unit(random));
        const glm::dvec3 out = direction(unit(random), 6.0 * unit(random));
        EXPECT_DOUBLE_EQ(reflectance({0.7, 0.0, 1000.0 * unit(random)}, in, out), 0.7 / kPi);
    }
    for (const double cosOut : {0.05, 0.5, 1.0}) {
        EXPECT_NEAR(underAnEvenSky({0.7, 0.0, 32.0}, direction(cosOut, 0.0)), 0.7, 2e-3);
    }
}

TEST(SurfaceLight, IsTheSameBothWays) {
    std::mt19937 random(10);
    std::uniform_real_distribution<double> unit(0.01, 1.0);
    for (int i = 0; i < 500; ++i) {
        const Material material{unit(random), unit(random), 1.0 + 999.0 * unit(random)};
        const glm::dvec3 in = direction(unit(random), 6.0 * unit(random));
        const glm::dvec3 out = direction(unit(random), 6.0 * unit(random));
        const double there = reflectance(material, in, out);
        EXPECT_NEAR(there, reflectance(material, out, in), 1e-12 * there);
    }
}

// Nearly all that a smooth mirror takes comes back, and in the mirror's direction.
TEST(SurfaceLight, AMirrorReflectsItsShare) {
    for (const double cosOut : {0.3, 0.7, 1.0}) {
        EXPECT_NEAR(underAnEvenSky({0.0, 1.0, 1000.0}, direction(cosOut, 0.0)), 1.0, 0.02);
        EXPECT_NEAR(underAnEvenSky({0.0, 0.1, 1000.0}, direction(1.0, 0.0)), 0.1, 0.005);
    }
}

// A highlight is as bright as that of the Blinn-Phong exponent that shininess is named after: its normalised
// distribution (n + 2) / (2 pi) in the middle, over 4 for the half vector.
TEST(SurfaceLight, AHighlightIsAsBrightAsItsPhongExponentSays) {
    for (const double shininess : {1.0, 64.0, 1000.0}) {
        const double glossy = reflectance({0.0, 0.3, shininess}, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0});
        EXPECT_NEAR(glossy, 0.3 * (shininess + 2.0) / (8.0 * kPi), 1e-9 * shininess);
    }
}

TEST(SurfaceLight, FloatsStayFiniteAtEveryExtreme) {
    render::glsl::Formulas<float> formulas;
    for (const float cosIn : {1e-6f, 1e-3f, 1.0f}) {
        for (const float cosOut : {1e-4f, 1.0f}) {
            for (const float specular : {0.0f, 1.0f}) {
                for (const float shininess : {1.0f, 1000.0f}) {
                    float diffuse = 0.0f, glossy = 0.0f;
                    formulas.surfaceReflection(cosIn, cosOut, 1.0f, 1.0f, specular, shininess, diffuse,
                                               glossy);
                    EXPECT_TRUE(std::isfinite(diffuse) && std::isfinite(glossy));
                    EXPECT_GE(diffuse, 0.0f);
                }
            }
        }
    }
}

}  // namespace
}  // namespace hazer::test
