// What a scene does not need is not in its plan.
#include "render/scene_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <glm/gtc/matrix_transform.hpp>

namespace hazer::test {
namespace {

using render::Beam;
using render::Scene;
using render::ScenePlan;

constexpr std::array<render::MeshBounds, 1> kUnitSphere{
    {{{glm::vec3(0.0f), 0.5f}, {glm::vec3(-0.5f), glm::vec3(0.5f)}}}};

/// A soft lamp at 6 m that shines down, and a ball of 1 m at `ball`.
Scene sceneWithBall(const glm::dvec3& ball) {
    Scene scene;
    Beam beam;
    beam.lensPositionM = {0.0, 0.0, 6.0};
    beam.fluxLm = 1000.0;
    scene.beams.push_back(beam);
    render::MeshInstance instance;
    instance.mesh = 0;
    instance.worldFromMesh = glm::translate(glm::dmat4(1.0), ball);
    scene.instances.push_back(instance);
    return scene;
}

ScenePlan plan(const Scene& scene, const render::Settings& settings = {}) {
    return render::planScene(scene, {}, settings, kUnitSphere);
}

/// What the one group of beams in the air is drawn with.
render::LightFeatures onlyFeatures(const ScenePlan& p) {
    EXPECT_EQ(p.airGroups.size(), 1u);
    return p.airGroups.empty() ? 0u : p.airGroups.front().features;
}

void expectListed(const std::vector<render::BeamGroup>& groups,
                  const std::vector<render::LightFeatures>& all) {
    for (const render::BeamGroup& group : groups) {
        EXPECT_NE(std::find(all.begin(), all.end(), group.features), all.end());
    }
}

TEST(ScenePlan, AFullSceneHasEverything) {
    Scene scene = sceneWithBall({0.0, 0.0, 2.0});
    scene.beams.front().gobo = 0;
    scene.haze.noise.amount = 0.5f;
    const ScenePlan p = plan(scene);
    EXPECT_TRUE(p.air && p.surfaces && p.bloom);
    EXPECT_EQ(p.lenses.size(), 1u);
    ASSERT_EQ(p.shadowMaps.size(), 1u);
    ASSERT_EQ(p.surfaceGroups.size(), 1u);
    EXPECT_EQ(p.surfaceGroups.front().features, render::kFeatureGobo | render::kFeatureShadow);
    EXPECT_EQ(onlyFeatures(p), render::kFeatureGobo | render::kFeatureShadow | render::kFeatureNoise);
}

TEST(ScenePlan, AWebGivesTheBeamItsShape) {
    render::IesTable table;
    table.verticalDeg = {0.0, 40.0};
    table.horizontalDeg = {0.0};
    table.candela = {700.0, 700.0};
    const std::array<render::IesWeb, 1> webs{render::makeIesWeb(table)};
    Scene scene = sceneWithBall({0.0, 0.0, 2.0});
    scene.beams.front().fluxLm = 0.0;
    scene.beams.front().web = 0;
    const ScenePlan p = render::planScene(scene, {}, {}, kUnitSphere, webs);
    EXPECT_EQ(p.shapes.front().peakCd, 700.0);
    EXPECT_NEAR(p.shapes.front().cutHalfAngleRad, 40.0 * 3.14159265 / 180.0, 0.01);
    ASSERT_EQ(p.airGroups.size(), 1u);
    EXPECT_EQ(p.airGroups.front().features & (render::kFeatureWeb | render::kFeatureFlat),
              render::kFeatureWeb);
    ASSERT_EQ(p.lenses.size(), 1u);
    EXPECT_EQ(p.lenses.front().features, render::kFeatureWeb);
}

TEST(ScenePlan, NoHazeNoVolume) {
    Scene scene = sceneWithBall({0.0, 0.0, 2.0});
    scene.haze.scatteringPerM = 0.0f;
    scene.haze.noise.amount = 1.0f;
    const ScenePlan p = plan(scene);
    EXPECT_FALSE(p.air);
    EXPECT_TRUE(p.airGroups.empty());
    EXPECT_EQ(p.surfaceGroups.size(), 1u);
}

TEST(ScenePlan, NoCasterInTheConeNoShadow) {
    for (const glm::dvec3& beside : {glm::dvec3(4.0, 0.0, 3.0), glm::dvec3(0.0, 0.0, 9.0)}) {
        const ScenePlan p = plan(sceneWithBall(beside));
        EXPECT_TRUE(p.shadowMaps.empty());
        EXPECT_TRUE(p.shadowsLeftOut.empty());
        EXPECT_EQ(onlyFeatures(p) & render::kFeatureShadow, 0u);
    }
}

TEST(ScenePlan, ThatWhichCastsNoneOrIsSwitchedOffHasNoMap) {
    Scene scene = sceneWithBall({0.0, 0.0, 2.0});
    render::Settings off;
    off.shadows = false;
    EXPECT_TRUE(plan(scene, off).shadowMaps.empty());
    scene.instances.front().castsShadow = false;
    EXPECT_TRUE(plan(scene).shadowMaps.empty());
}

TEST(ScenePlan, DarkFixturesAreNotDrawn) {
    Scene scene = sceneWithBall({0.0, 0.0, 2.0});
    scene.beams.front().fluxLm = 0.0;
    EXPECT_TRUE(plan(scene).airGroups.empty());
    EXPECT_TRUE(plan(scene).surfaceGroups.empty());
    EXPECT_TRUE(plan(scene).lenses.empty());
    scene.beams.front().fluxLm = 1000.0;
    scene.beams.front().color = glm::vec3(0.0f);
    EXPECT_TRUE(plan(scene).airGroups.empty());
}

TEST(ScenePlan, GobosSwitchedOffLeaveNoGoboCode) {
    Scene scene = sceneWithBall({9.0, 0.0, 2.0});
    scene.beams.front().gobo = 3;
    render::Settings off;
    off.gobos = false;
    EXPECT_EQ(onlyFeatures(plan(scene, off)) & render::kFeatureGobo, 0u);
}

TEST(ScenePlan, BeamsAreGroupedByWhatTheyNeed) {
    Scene scene = sceneWithBall({9.0, 0.0, 2.0});
    Beam other = scene.beams.front();
    other.gobo = 0;
    scene.beams.push_back(other);
    scene.beams.push_back(scene.beams.front());
    const ScenePlan p = plan(scene);
    ASSERT_EQ(p.airGroups.size(), 2u);
    std::size_t beams = 0;
    for (const render::BeamGroup& group : p.airGroups) beams += group.beams.size();
    EXPECT_EQ(beams, 3u);
}

TEST(ScenePlan, ABeamThatMeetsNoSurfaceLightsTheAirAlone) {
    const ScenePlan p = plan(sceneWithBall({9.0, 0.0, 2.0}));
    EXPECT_TRUE(p.surfaces);
    EXPECT_TRUE(p.surfaceGroups.empty());
    EXPECT_FALSE(p.surfaceReach.front().has_value());
    EXPECT_EQ(p.airGroups.size(), 1u);
}

TEST(ScenePlan, ACoarseGridOnlyWhereItPays) {
    Scene scene = sceneWithBall({0.0, 0.0, 2.0});
    render::Settings settings;
    EXPECT_EQ(plan(scene, settings).airStep, 1) << "no error is allowed for";
    settings.maxError = 0.01;
    EXPECT_EQ(plan(scene, settings).airStep, 4);
    settings.width = settings.height = 256;
    EXPECT_EQ(plan(scene, settings).airStep, 1) << "a small picture";
    settings.airStep = 2;
    EXPECT_EQ(plan(scene, settings).airStep, 2) << "asked for by name";
    settings = {};
    settings.maxError = 0.01;
    scene.beams.front().edge = render::BeamEdge::kFlat;
    EXPECT_EQ(plan(scene, settings).airStep, 1) << "flat beams are cheap";
    scene.haze.noise.amount = 0.5f;
    EXPECT_EQ(plan(scene, settings).airStep, 4) << "but not in uneven haze";
    scene.haze.noise.amount = 0.0f;
    scene.beams.resize(20, scene.beams.front());
    EXPECT_EQ(plan(scene, settings).airStep, 4) << "nor if there are many";
}

TEST(ScenePlan, AWideLampNeedsShadowMapsAllAround) {
    Scene scene = sceneWithBall({0.0, 0.0, 2.0});
    scene.beams.front().fieldAngleRad = 3.0;
    scene.beams.front().beamAngleRad = 2.0;
    const ScenePlan p = plan(scene);
    EXPECT_EQ(onlyFeatures(p), render::kFeatureShadow | render::kFeatureWide);
    expectListed(p.airGroups, render::allAirVariants());
    expectListed(p.surfaceGroups, render::allSurfaceVariants());
}

TEST(ScenePlan, OnlyALampWiderThanAHalfSpaceShinesBackwards) {
    Scene scene = sceneWithBall({0.0, 0.0, 2.0});
    Beam& beam = scene.beams.front();
    beam.edge = render::BeamEdge::kFlat;
    beam.castsShadow = false;
    for (const double fieldDeg : {20.0, 179.0, 180.0, 181.0, 358.0}) {
        beam.fieldAngleRad = glm::radians(fieldDeg);
        const render::LightFeatures further = fieldDeg > 180.0 ? render::kFeatureBackwards : 0u;
        EXPECT_EQ(onlyFeatures(plan(scene)), render::kFeatureFlat | further) << fieldDeg;
        ASSERT_EQ(plan(scene).surfaceGroups.size(), 1u);
        EXPECT_EQ(plan(scene).surfaceGroups.front().features, render::kFeatureFlat);
        expectListed(plan(scene).airGroups, render::allAirVariants());
    }
    beam.castsShadow = true;
    EXPECT_EQ(onlyFeatures(plan(scene)), render::kFeatureFlat | render::kFeatureShadow |
                                             render::kFeatureWide | render::kFeatureBackwards);
    expectListed(plan(scene).airGroups, render::allAirVariants());
    render::Settings thesis;
    thesis.integrator = render::Integrator::kUniform;
    EXPECT_EQ(onlyFeatures(plan(scene, thesis)) & render::kFeatureBackwards, 0u);
}

TEST(ScenePlan, OnlyAThinBeamIsALine) {
    Scene scene = sceneWithBall({9.0, 0.0, 2.0});
    Beam& beam = scene.beams.front();
    beam.edge = render::BeamEdge::kFlat;
    beam.lensRadiusM = 0.0;
    for (const double fieldDeg : {0.02, 0.5, 10.0}) {
        beam.fieldAngleRad = glm::radians(fieldDeg);
        const ScenePlan p = plan(scene);
        EXPECT_EQ(onlyFeatures(p), render::kFeatureFlat | (fieldDeg < 1.0 ? render::kFeatureLine : 0u))
            << fieldDeg;
        expectListed(p.airGroups, render::allAirVariants());
        for (const render::BeamGroup& group : p.surfaceGroups)
            EXPECT_EQ(group.features & render::kFeatureLine, 0u);
        render::Settings thesis;
        thesis.integrator = render::Integrator::kUniform;
        EXPECT_EQ(onlyFeatures(plan(scene, thesis)) & render::kFeatureLine, 0u);
    }
}

TEST(ScenePlan, ALampThatHidesItsLensHasNone) {
    Scene scene = sceneWithBall({9.0, 0.0, 2.0});
    scene.beams.front().showsLens = false;
    EXPECT_TRUE(plan(scene).lenses.empty());
    scene.beams.front().showsLens = true;
    scene.beams.front().lensRadiusM = 0.0;
    EXPECT_TRUE(plan(scene).lenses.empty());
}

TEST(ScenePlan, EveryGroupsVariantIsListed) {
    Scene scene = sceneWithBall({0.0, 0.0, 2.0});
    scene.haze.noise.amount = 1.0f;
    expectListed(plan(scene).airGroups, render::allAirVariants());
    expectListed(plan(scene).surfaceGroups, render::allSurfaceVariants());
}

}  // namespace
}  // namespace hazer::test
