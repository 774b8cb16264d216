// Which beams a coarse grid would miss.
#include "render/beam_width.h"

#include <gtest/gtest.h>

namespace hazer::test {
namespace {

constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;
constexpr int kHeight = 720;
constexpr double kStepPx = 4.0;

bool isThin(double fieldDeg, double lensRadiusM, double distanceM) {
    render::Beam beam;
    beam.edge = render::BeamEdge::kFlat;
    beam.fieldAngleRad = fieldDeg * kRadPerDeg;
    beam.lensRadiusM = lensRadiusM;
    render::Camera camera;
    camera.positionM = {0.0, -distanceM, 0.0};
    return render::isThinOnScreen(beam, render::beamShape(beam), camera, kHeight, kStepPx);
}

TEST(BeamWidth, AStageLampNearbyIsWide) {
    EXPECT_FALSE(isThin(25.0, 0.08, 10.0));
    EXPECT_FALSE(isThin(120.0, 0.0, 10.0));
}

TEST(BeamWidth, APencilBeamFromAPointIsThin) {
    EXPECT_TRUE(isThin(0.5, 0.0, 10.0));
    // 8 px wide only after 8 / (2 tan 2.5 deg) = 91 px.
    EXPECT_TRUE(isThin(5.0, 0.0, 10.0));
}

TEST(BeamWidth, ALensOfSomePixelsKeepsANarrowBeamWide) {
    // 720 px over tan: a pixel is 1.17 mrad, the lens 16 cm / 10 m = 16 mrad, 13 px.
    EXPECT_FALSE(isThin(3.0, 0.08, 10.0));
    EXPECT_TRUE(isThin(3.0, 0.08, 100.0));
}

TEST(BeamWidth, AnOpeningBelowThePixelsIsThinHoweverLargeTheLens) {
    EXPECT_TRUE(isThin(0.3, 0.5, 1.0));
}

TEST(BeamWidth, TheSurroundingsOfALensReachToWhereTheBeamIsTwoStepsWide) {
    render::Beam beam;
    beam.edge = render::BeamEdge::kFlat;
    beam.fieldAngleRad = 40.0 * kRadPerDeg;
    beam.lensRadiusM = 0.0;
    beam.lensPositionM = {0.0, 0.0, 1.7};
    const render::Camera camera;  // 10 m away, looks at the lens
    const auto square =
        render::thinSurroundings(beam, render::beamShape(beam), camera, {1280, kHeight}, kStepPx);
    ASSERT_TRUE(square);
    EXPECT_NEAR(square->centerPx.x, 640.0, 1e-9);
    EXPECT_NEAR(square->centerPx.y, 360.0, 1e-9);
    // 8 px over twice the tangent of 20 degrees, and a step.
    EXPECT_NEAR(square->halfEdgePx, 8.0 / 0.72794 + kStepPx, 1e-3);
}

TEST(BeamWidth, ALargeLensOrOneBehindTheCameraHasNoThinSurroundings) {
    render::Beam beam;
    beam.fieldAngleRad = 40.0 * kRadPerDeg;
    beam.lensRadiusM = 0.3;
    beam.lensPositionM = {0.0, 0.0, 1.7};
    const render::Camera camera;
    EXPECT_FALSE(render::thinSurroundings(beam, render::beamShape(beam), camera, {1280, kHeight}, kStepPx));
    beam.lensRadiusM = 0.0;
    beam.lensPositionM = {0.0, -20.0, 1.7};
    EXPECT_FALSE(render::thinSurroundings(beam, render::beamShape(beam), camera, {1280, kHeight}, kStepPx));
}

}  // namespace
}  // namespace hazer::test
