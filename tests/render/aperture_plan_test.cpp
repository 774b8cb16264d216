// Which beams need a composed picture of what stands in their way, and which get by without.
#include "render/aperture_plan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/gobo_table_plan.h"
#include "render/photometry.h"
#include "render/scene_plan.h"

namespace hazer::test {
namespace {

using render::AperturePlan;
using render::Beam;
using render::Scene;

constexpr double kPi = 3.14159265358979323846;

Beam lamp() {
    Beam beam;
    beam.fluxLm = 1000.0;
    return beam;
}

Beam withBlade(double distance) {
    Beam beam = lamp();
    beam.aperture.blades[0].distance = distance;
    return beam;
}

AperturePlan planOf(const std::vector<Beam>& beams, const render::Settings& settings = {}) {
    Scene scene;
    scene.beams = beams;
    return render::planScene(scene, {}, settings, {}).apertures;
}

TEST(AperturePlan, AnOpenBeamNeedsNoPicture) {
    Beam gobo = lamp();
    gobo.gobo = 0;
    Beam colors = lamp();
    colors.aperture.beyondColor = glm::vec3(0.5f);  // its edge is out of the field
    const AperturePlan plan = planOf({lamp(), gobo, withBlade(1.0), colors});
    EXPECT_TRUE(plan.composed.empty());
    EXPECT_EQ(plan.ofBeam, std::vector<int>(4, -1));
}

TEST(AperturePlan, EveryKindOfObstacleNeedsOne) {
    std::vector<Beam> beams(6, lamp());
    beams[0].aperture.blades[3].distance = 0.9;
    beams[1].aperture.images[1].gobo = 2;
    beams[2].aperture.rectangle.emplace();
    beams[3].aperture.split.distance = 0.0;
    beams[3].aperture.beyondColor = {1.0f, 0.0f, 0.0f};
    beams[4].aperture.irisRadius = 0.5;
    beams[4].gobo = 1;
    beams[5].aperture.irisRadius = 0.5;
    beams[5].aperture.softness = 0.2;
    EXPECT_EQ(planOf(beams).ofBeam, (std::vector<int>{0, 1, 2, 3, 4, 5}));
    render::Settings without;
    without.gobos = false;
    EXPECT_TRUE(planOf(beams, without).composed.empty());
}

TEST(AperturePlan, DarkBeamsNeedNone) {
    Beam dark = withBlade(0.2);
    dark.fluxLm = 0.0;
    EXPECT_TRUE(planOf({dark}).composed.empty());
}

TEST(AperturePlan, BeamsThatLightNothingNeedNone) {
    Scene scene;
    scene.beams = {withBlade(0.2)};
    scene.beams[0].showsLens = false;
    scene.haze.scatteringPerM = 0.0f;
    EXPECT_TRUE(render::planScene(scene, {}, {}, {}).apertures.composed.empty());
}

TEST(AperturePlan, EqualOnesShareAPicture) {
    EXPECT_EQ(planOf({withBlade(0.2), withBlade(0.3), withBlade(0.2)}).ofBeam, (std::vector<int>{0, 1, 0}));
}

// A gobo that turns behind an iris turns the picture of both; behind blades it does not.
TEST(AperturePlan, AnIrisLeavesTheTurningToTheBeam) {
    Beam first = lamp();
    first.gobo = 0;
    first.goboRotationRad = 0.4;
    first.aperture.irisRadius = 0.5;
    Beam second = first;
    second.goboRotationRad = 1.4;
    EXPECT_EQ(planOf({first, second}).ofBeam, (std::vector<int>{0, 0}));
    EXPECT_EQ(render::pictureRotationRad(second), 1.4);
    second.aperture.blades[0].distance = 0.1;
    const AperturePlan plan = planOf({first, second});
    EXPECT_EQ(plan.ofBeam, (std::vector<int>{0, 1}));
    EXPECT_EQ(plan.composed[1].rotationRad, 1.4);
    EXPECT_EQ(render::pictureRotationRad(second), 0.0);
}

TEST(AperturePlan, MoreThanThereIsRoomForShineWithout) {
    std::vector<Beam> beams;
    for (int i = 0; i <= render::kMostComposedApertures; ++i) beams.push_back(withBlade(0.01 * i));
    beams.push_back(withBlade(0.0));
    const AperturePlan plan = planOf(beams);
    EXPECT_EQ(plan.composed.size(), static_cast<std::size_t>(render::kMostComposedApertures));
    EXPECT_EQ(plan.leftOut, std::vector<int>{render::kMostComposedApertures});
    EXPECT_EQ(plan.ofBeam.back(), 0);
}

TEST(AperturePlan, NoTableIsWantedOfAComposedPicture) {
    Scene scene;
    scene.beams = {lamp(), lamp()};
    scene.beams[0].gobo = 0;
    scene.beams[1].gobo = 0;
    scene.beams[1].aperture.blades[0].distance = 0.0;
    const auto keys = render::goboTableKeys(scene, {}, render::planScene(scene, {}, {}, {}));
    EXPECT_EQ(keys[0].gobo, 0);
    EXPECT_EQ(keys[1].gobo, -1);
}

// An iris alone is a narrower beam of the same candelas: what it lets through is the flux within its cone.
TEST(AperturePlan, AnIrisAloneIsANarrowerBeam) {
    for (const render::BeamEdge edge : {render::BeamEdge::kFlat, render::BeamEdge::kSoft}) {
        Beam beam = lamp();
        beam.edge = edge;
        const render::BeamShape open = render::beamShape(beam);
        beam.aperture.irisRadius = 0.5;
        const render::BeamShape half = render::beamShape(beam);
        EXPECT_TRUE(planOf({beam}).composed.empty());
        EXPECT_EQ(half.peakCd, open.peakCd);
        EXPECT_EQ(half.apexToLensM, open.apexToLensM);
        EXPECT_NEAR(std::tan(half.cutHalfAngleRad), 0.5 * std::tan(open.fieldHalfAngleRad), 1e-12);
        double flux = 0.0;
        constexpr int kRings = 20000;
        for (int i = 0; i < kRings; ++i) {
            const double psi = (i + 0.5) / kRings * half.cutHalfAngleRad;
            flux += open.peakCd * render::relativeIntensity(open, psi) * 2.0 * kPi * std::sin(psi) *
                    half.cutHalfAngleRad / kRings;
        }
        EXPECT_NEAR(half.peakCd * render::profileSolidAngle(half), flux, 1e-6 * flux);
        beam.aperture.irisRadius = 0.0;
        EXPECT_EQ(render::beamShape(beam).peakCd, 0.0);
    }
}

}  // namespace
}  // namespace hazer::test
