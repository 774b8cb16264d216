// Which tables a frame wants.
#include "render/gobo_table_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hazer::test {
namespace {

using render::Beam;
using render::BeamShape;
using render::GoboTableKey;

constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;

Beam spot(double fieldDeg, double beamOverField) {
    Beam beam;
    beam.gobo = 3;
    beam.fluxLm = 1000.0;
    beam.fieldAngleRad = fieldDeg * kRadPerDeg;
    beam.beamAngleRad = beamOverField * beam.fieldAngleRad;
    beam.edge = beamOverField < 1.0 ? render::BeamEdge::kSoft : render::BeamEdge::kFlat;
    return beam;
}

GoboTableKey keyOf(const Beam& beam) {
    return render::goboTableKey(beam, render::beamShape(beam));
}

std::vector<GoboTableKey> keysOf(const render::Scene& scene, const render::Settings& settings = {}) {
    return render::goboTableKeys(scene, settings, render::planScene(scene, {}, settings, {}));
}

TEST(GoboTablePlan, ZoomAndRotationWantTheSameTable) {
    for (const double beamOverField : {0.3, 0.55, 0.8, 0.97, 1.0}) {
        const GoboTableKey key = keyOf(spot(20.0, beamOverField));
        EXPECT_EQ(key.gobo, 3);
        for (const double fieldDeg : {0.5, 3.0, 11.7, 45.0, 69.0}) {
            Beam beam = spot(fieldDeg, beamOverField);
            beam.goboRotationRad = fieldDeg;
            beam.focusDistanceM = 4.0;
            beam.color = {0.5f, 2.0f, 0.1f};
            EXPECT_EQ(keyOf(beam), key) << fieldDeg << ", " << beamOverField;
        }
    }
}

TEST(GoboTablePlan, OtherProfilesWantOtherTables) {
    EXPECT_NE(keyOf(spot(20.0, 0.8)), keyOf(spot(20.0, 0.9)));
    EXPECT_NE(keyOf(spot(20.0, 1.0)), keyOf(spot(20.0, 0.9)));
    Beam other = spot(20.0, 0.8);
    other.gobo = 4;
    EXPECT_NE(keyOf(other), keyOf(spot(20.0, 0.8)));
}

// What rounding the profile does to the light.
TEST(GoboTablePlan, ARoundedProfileIsTheProfile) {
    for (double beamOverField = 0.1; beamOverField < 0.999; beamOverField += 0.00137) {
        const Beam beam = spot(20.0, beamOverField);
        const BeamShape shape = render::beamShape(beam);
        const render::GoboProfile profile = keyOf(beam).profile;
        for (double q = 0.0; q < 1.0; q += 0.05) {
            const double exact =
                std::exp2(-std::pow(q * shape.fieldHalfAngleRad / shape.beamHalfAngleRad, shape.exponent));
            const double rounded = std::exp2(-std::pow(q / profile.beamOverField, profile.exponent));
            EXPECT_NEAR(rounded, exact, 0.004) << beamOverField << ", " << q;
        }
    }
}

TEST(GoboTablePlan, NoTableWithoutAGoboOrForAWideBeam) {
    Beam open = spot(20.0, 0.8);
    open.gobo = -1;
    EXPECT_EQ(keyOf(open), GoboTableKey{});
    EXPECT_EQ(keyOf(spot(75.0, 0.8)), GoboTableKey{});
}

TEST(GoboTablePlan, NoTableThatNothingLooksAt) {
    render::Scene scene;
    scene.beams = {spot(20.0, 0.8), spot(20.0, 0.8), spot(20.0, 1.0)};
    scene.beams[1].fluxLm = 0.0;
    const GoboTableKey soft = keyOf(scene.beams[0]);
    const GoboTableKey flat = keyOf(scene.beams[2]);
    EXPECT_EQ(keysOf(scene), (std::vector<GoboTableKey>{soft, {}, flat}));

    const std::vector<GoboTableKey> none(3);
    render::Settings settings;
    settings.gobos = false;
    EXPECT_EQ(keysOf(scene, settings), none);
    settings.gobos = true;
    settings.integrator = render::Integrator::kUniform;
    EXPECT_EQ(keysOf(scene, settings), none);
    settings.integrator = render::Integrator::kAngle;
    settings.samples = 4096;
    EXPECT_EQ(keysOf(scene, settings), none);
    scene.haze.scatteringPerM = 0.0f;
    EXPECT_EQ(keysOf(scene), none);
}

}  // namespace
}  // namespace hazer::test
