// Where a shadow map looks: the clip of a ray against brute force, and the shaders' arithmetic against the
// matrices.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <random>

#include "render/glsl_as_cpp.h"
#include "render/gpu_beam.h"
#include "render/shadow_projection.h"

namespace hazer::test {
namespace {

using Random = std::mt19937;
using render::kCubeFaces;

double uniform(Random& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

glm::dvec3 anyDirection(Random& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
}

template <typename Scalar>
void expectClipAgreesWithBruteForce(Scalar rounding) {
    using Formulas = render::glsl::Formulas<Scalar>;
    using Real3 = typename Formulas::Real3;
    Random random(6);
    Formulas formulas;
    int met = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        const glm::dvec3 start(uniform(random, -5, 5), uniform(random, -5, 5), uniform(random, -8, 4));
        const glm::dvec3 along = anyDirection(random);
        const glm::dvec2 a(uniform(random, -1, 1), uniform(random, -1, 1));
        const glm::dvec2 b(uniform(random, -1, 1), uniform(random, -1, 1));
        const glm::dvec2 low = glm::min(a, b), high = glm::max(a, b);
        const double nearM = uniform(random, 0.1, 5.0);
        const double first = uniform(random, -20, 0), last = uniform(random, 0, 20);
        Scalar sFrom(static_cast<Scalar>(first)), sTo(static_cast<Scalar>(last));
        const auto real = [](double v) { return static_cast<Scalar>(v); };
        const bool meets = formulas.cutToWindow(
            Real3(start), Real3(along), {real(nearM), real(low.x), real(low.y), real(high.x), real(high.y)},
            sFrom, sTo);
        met += meets ? 1 : 0;
        constexpr int kSteps = 400;
        for (int i = 0; i <= kSteps; ++i) {
            const double s = first + (last - first) * i / kSteps;
            const glm::dvec3 p = start + s * along;
            const bool isInside = -p.z >= nearM && p.x >= low.x * -p.z && p.x <= high.x * -p.z &&
                                  p.y >= low.y * -p.z && p.y <= high.y * -p.z;
            const double slack = static_cast<double>(rounding) * (1.0 + std::abs(s)) /
                                 std::max(1e-3, std::min(std::abs(along.z), 1.0));
            const bool isKept =
                meets && s >= static_cast<double>(sFrom) - slack && s <= static_cast<double>(sTo) + slack;
            const bool isWellKept =
                meets && s > static_cast<double>(sFrom) + slack && s < static_cast<double>(sTo) - slack;
            EXPECT_TRUE(isKept || !isInside) << "trial " << trial << ", s " << s;
            EXPECT_TRUE(isInside || !isWellKept) << "trial " << trial << ", s " << s;
        }
    }
    EXPECT_GT(met, 400);
}

TEST(ShadowFrustum, ARayIsCutAsBruteForceSays) {
    expectClipAgreesWithBruteForce<double>(1e-9);
    expectClipAgreesWithBruteForce<float>(1e-3f);
}

TEST(ShadowFrustum, FacesOfTheCubeAreTheSameInShadersAndOutside) {
    Random random(7);
    render::glsl::Formulas<double> formulas;
    for (int trial = 0; trial < 500; ++trial) {
        const glm::dvec3 direction = anyDirection(random);
        for (int face = 0; face < kCubeFaces; ++face) {
            const glm::dmat3 turn = render::faceFromLamp(face);
            EXPECT_NEAR(glm::determinant(turn), 1.0, 1e-12) << "a turn, no mirror";
            EXPECT_NEAR(glm::distance(turn * direction, formulas.toShadowFace(direction, face)), 0.0, 1e-12);
        }
        // Its own face sees it best: within the pyramid of 45 degrees.
        const glm::dvec3 own = formulas.toShadowFace(direction, formulas.shadowFaceOf(direction));
        EXPECT_LE(std::max(std::abs(own.x), std::abs(own.y)), -own.z);
    }
    EXPECT_EQ(formulas.shadowFaceOf(glm::dvec3(0.0, 0.0, -1.0)), 0);
    EXPECT_EQ(formulas.shadowFaceOf(glm::dvec3(0.0, 0.0, 1.0)), 5);
}

/// The record that shaders look texels up with says where the matrix draws.
TEST(ShadowProjection, RecordAndMatrixMeanTheSameTexel) {
    Random random(8);
    for (int trial = 0; trial < 500; ++trial) {
        render::ShadowFacePlan face;
        const glm::dvec2 a(uniform(random, -1, 1), uniform(random, -1, 1));
        const glm::dvec2 b(uniform(random, -1, 1), uniform(random, -1, 1));
        face.rect = {glm::min(a, b), glm::max(a, b)};
        face.nearM = uniform(random, 0.1, 5.0);
        face.sizeTexels = 64 << (random() % 6);
        const render::ShadowProjection projection = render::shadowProjection(face);
        const render::ShadowTile tile{{512, 256}, face.sizeTexels, true};
        const render::ShadowFaceRecord record = render::faceRecord(projection, tile);
        const double axialM = face.nearM * uniform(random, 1.0, 50.0);
        const glm::dvec2 tangent(uniform(random, face.rect.low.x, face.rect.high.x),
                                 uniform(random, face.rect.low.y, face.rect.high.y));
        const glm::dvec4 clip = render::clipFromFace(projection) * glm::dvec4(tangent * axialM, -axialM, 1.0);
        const double window = face.sizeTexels - 2.0 * render::kShadowRimTexels;
        const glm::dvec2 drawn = glm::dvec2(tile.originPx) + double{render::kShadowRimTexels} +
                                 window * (0.5 + 0.5 * glm::dvec2(clip) / clip.w);
        const glm::dvec2 lookedUp =
            tangent * glm::dvec2(record.map.x, record.map.y) + glm::dvec2(record.map.z, record.map.w);
        // Floats: a narrow window far from the axis costs some hundredths of a texel.
        EXPECT_NEAR(glm::distance(drawn, lookedUp), 0.0, 0.05);
        EXPECT_NEAR(0.5 + 0.5 * clip.z / clip.w, face.nearM / axialM, 1e-12);
        // Two texels are left around the casters, within the rim.
        EXPECT_GE(std::min(drawn.x - 512.0, drawn.y - 256.0), 3.0 - 1e-6);
        EXPECT_LE(std::max(drawn.x - 512.0, drawn.y - 256.0), face.sizeTexels - 3.0 + 1e-6);
    }
}

TEST(ShadowProjection, WhatIsSeenEdgeOnStillHasAMap) {
    render::ShadowFacePlan face;
    face.rect = {{0.1, -0.2}, {0.1, 0.2}};
    face.nearM = 1.0;
    face.sizeTexels = 64;
    const glm::dmat4 clip = render::clipFromFace(render::shadowProjection(face));
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) EXPECT_TRUE(std::isfinite(clip[column][row]));
    }
}

/// A place in the world comes out where the lamp sees it, a hundred kilometres from the origin.
TEST(ShadowProjection, LooksOutOfTheLampWhereverItHangs) {
    render::Beam beam;
    beam.lensPositionM = {1e5, -5e4, 6.0};
    beam.worldFromBeam = glm::mat3_cast(glm::angleAxis(0.7, glm::normalize(glm::dvec3(1, 2, 0.5))));
    const render::BeamShape shape = render::beamShape(beam);
    render::ShadowFacePlan face;
    face.rect = {{-0.1, -0.2}, {0.3, 0.2}};
    face.nearM = 2.0;
    face.sizeTexels = 256;
    const render::ShadowProjection projection = render::shadowProjection(face);
    const glm::dmat4 clipFromWorld = render::clipFromWorld(beam, shape, 0, projection);
    const glm::dvec3 inLamp(0.2 * 7.0, -0.1 * 7.0, -7.0);
    const glm::dvec3 inWorld = render::apexPosition(beam, shape) + beam.worldFromBeam * inLamp;
    const glm::dvec4 clip = clipFromWorld * glm::dvec4(inWorld, 1.0);
    const glm::dvec4 expected = render::clipFromFace(projection) * glm::dvec4(inLamp, 1.0);
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(clip[k], expected[k], 1e-9);
}

}  // namespace
}  // namespace hazer::test
