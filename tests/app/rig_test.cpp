#include "app/rig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "fixtures/color.h"

namespace hazer::app {
namespace {

fixtures::BeamState litBeam() {
    fixtures::BeamState state;
    state.fluxLm = 10000.0;
    state.colorXyz = fixtures::xyzFromTemperature(6500.0);
    return state;
}

TEST(BeamFromState, aDarkLampGivesNoBeam) {
    fixtures::BeamState state = litBeam();
    state.fluxLm = 0.0;
    EXPECT_FALSE(beamFromState(state));
    state = litBeam();
    state.colorXyz = glm::dvec3(0.0);
    EXPECT_FALSE(beamFromState(state));
    state = litBeam();
    state.type = fixtures::BeamType::kNone;
    EXPECT_FALSE(beamFromState(state));
}

TEST(BeamFromState, fluxIsWhatTheColourLetsThrough) {
    fixtures::BeamState state = litBeam();
    state.colorXyz *= 0.25;
    const auto beam = beamFromState(state);
    ASSERT_TRUE(beam);
    EXPECT_NEAR(beam->fluxLm, 2500.0, 1e-6);
    EXPECT_NEAR(0.2627 * beam->color.r + 0.6780 * beam->color.g + 0.0593 * beam->color.b, 1.0, 1e-3);
}

TEST(BeamFromState, carriesPoseAndOptics) {
    fixtures::BeamState state = litBeam();
    state.worldFromBeam = glm::rotate(glm::translate(glm::dmat4(1.0), {1.0, 2.0, 3.0}), 0.5, {1.0, 0.0, 0.0});
    state.lensRadiusM = 0.07;
    state.beamAngleDeg = 10.0;
    state.fieldAngleDeg = 20.0;
    const auto beam = beamFromState(state);
    ASSERT_TRUE(beam);
    EXPECT_EQ(beam->lensPositionM, glm::dvec3(1.0, 2.0, 3.0));
    EXPECT_NEAR(-beam->worldFromBeam[2].y, std::sin(0.5), 1e-12);
    EXPECT_NEAR(-beam->worldFromBeam[2].z, -std::cos(0.5), 1e-12);
    EXPECT_EQ(beam->lensRadiusM, 0.07);
    EXPECT_NEAR(beam->beamAngleRad, 0.174533, 1e-6);
    EXPECT_NEAR(beam->fieldAngleRad, 0.349066, 1e-6);
}

TEST(BeamFromState, equalAnglesAreAHardEdge) {
    fixtures::BeamState state = litBeam();
    state.beamAngleDeg = state.fieldAngleDeg = 20.0;
    EXPECT_EQ(beamFromState(state)->edge, render::BeamEdge::kFlat);
    state.fieldAngleDeg = 22.0;
    EXPECT_EQ(beamFromState(state)->edge, render::BeamEdge::kSoft);
}

TEST(BeamFromState, staysWithinWhatTheRendererTakes) {
    fixtures::BeamState state = litBeam();
    state.beamAngleDeg = 200.0;
    state.fieldAngleDeg = 190.0;
    const auto beam = beamFromState(state);
    EXPECT_LE(beam->fieldAngleRad, 3.1);
    EXPECT_LE(beam->beamAngleRad, beam->fieldAngleRad);
    state.beamAngleDeg = state.fieldAngleDeg = 0.0;
    EXPECT_GT(beamFromState(state)->beamAngleRad, 0.0);
}

TEST(BeamFromState, withoutAFocusIsSharpEverywhere) {
    fixtures::BeamState state = litBeam();
    state.focus.reset();
    EXPECT_EQ(beamFromState(state)->focusDistanceM, 0.0);
    state.focus = 0.8;
    EXPECT_NEAR(beamFromState(state)->focusDistanceM, 10.0, 1e-9);
}

TEST(FocusDistance, runsFromTwoMetresToAKilometre) {
    EXPECT_NEAR(focusDistanceM(0.0), 2.0, 1e-12);
    EXPECT_NEAR(focusDistanceM(0.5), 4.0, 1e-12);
    EXPECT_NEAR(focusDistanceM(0.8), 10.0, 1e-9);
    EXPECT_NEAR(focusDistanceM(1.0), 1000.0, 1e-9);
    EXPECT_NEAR(focusDistanceM(-1.0), 2.0, 1e-12);
}

}  // namespace
}  // namespace hazer::app
