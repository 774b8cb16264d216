// Which lamps have shadow maps, where the maps look, and how fine they are.
#include "render/shadow_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numeric>

#include "render/gpu_beam.h"

namespace hazer::test {
namespace {

using render::Beam;
using render::MeshInstance;
using render::Scene;
using render::ShadowFacePlan;
using render::ShadowPlan;

constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;
constexpr int kBall = 0, kBox = 1, kPlane = 2;

const std::array<render::MeshBounds, 3> kBounds{{
    {{glm::vec3(0.0f), 0.5f}, {glm::vec3(-0.5f), glm::vec3(0.5f)}},
    {{glm::vec3(0.0f), 0.8660254f}, {glm::vec3(-0.5f), glm::vec3(0.5f)}},
    {{glm::vec3(0.0f), 0.7071068f}, {glm::vec3(-0.5f, -0.5f, 0.0f), glm::vec3(0.5f, 0.5f, 0.0f)}},
}};

MeshInstance body(int mesh, const glm::dvec3& at, const glm::dvec3& size, bool castsShadow = true) {
    MeshInstance instance;
    instance.mesh = mesh;
    instance.worldFromMesh = glm::scale(glm::translate(glm::dmat4(1.0), at), size);
    instance.castsShadow = castsShadow;
    return instance;
}

/// A point source at 6 m that shines down, flat, over a floor that casts nothing.
Scene lampOverFloor(double halfAngleDeg) {
    Scene scene;
    Beam beam;
    beam.lensPositionM = {0.0, 0.0, 6.0};
    beam.lensRadiusM = 0.0;
    beam.edge = render::BeamEdge::kFlat;
    beam.fieldAngleRad = 2.0 * halfAngleDeg * kRadPerDeg;
    beam.intensityCd = 1000.0;
    scene.beams.push_back(beam);
    scene.instances.push_back(body(kPlane, {0.0, 0.0, 0.0}, {40.0, 40.0, 1.0}, false));
    return scene;
}

constexpr render::ShadowDetail kFromTheHouse{{0.0, -10.0, 2.0}, 0.001};

ShadowPlan plan(const Scene& scene, const render::ShadowDetail& detail = kFromTheHouse) {
    std::vector<int> lit(scene.beams.size());
    std::iota(lit.begin(), lit.end(), 0);
    std::vector<render::BeamShape> shapes;
    for (const Beam& beam : scene.beams) shapes.push_back(render::beamShape(beam));
    return render::planShadows(scene, lit, shapes, kBounds, detail, true);
}

const ShadowFacePlan& onlyFace(const ShadowPlan& p) {
    EXPECT_EQ(p.maps.size(), 1u);
    EXPECT_EQ(p.maps.front().faces.size(), 1u);
    return p.maps.front().faces.front();
}

TEST(ShadowPlan, AMapFitsItsCasters) {
    Scene scene = lampOverFloor(20.0);
    scene.instances.push_back(body(kBall, {0.5, 0.0, 2.0}, glm::dvec3(0.6)));
    const ShadowPlan p = plan(scene);
    const ShadowFacePlan& face = onlyFace(p);
    EXPECT_EQ(face.casters, std::vector<int>{1});
    EXPECT_NEAR(face.nearM, 3.7, 1e-9);
    // 0.3 m about (0.5, 0) at 4 m: as a box 0.8 / 3.7 to the right; the sphere is seen closer than its box.
    const double toMiddle = std::atan2(0.5, 4.0), half = std::asin(0.3 / std::hypot(0.5, 4.0));
    EXPECT_NEAR(face.rect.low.x, std::tan(toMiddle - half), 1e-9);
    EXPECT_NEAR(face.rect.high.x, std::tan(toMiddle + half), 1e-9);
    EXPECT_FALSE(p.maps.front().isWide);
}

TEST(ShadowPlan, ALongBodyIsCutToTheCone) {
    Scene scene = lampOverFloor(20.0);
    scene.instances.push_back(body(kBox, {0.0, 0.0, 4.0}, {12.0, 0.2, 0.2}));
    const ShadowPlan p = plan(scene);
    const ShadowFacePlan& face = onlyFace(p);
    EXPECT_NEAR(face.nearM, 1.9, 1e-9);
    EXPECT_NEAR(face.rect.high.x, std::tan(20.0 * kRadPerDeg), 1e-9);
    EXPECT_NEAR(face.rect.high.y, 0.1 / 1.9, 1e-9);
}

TEST(ShadowPlan, NoCasterInTheConeNoMap) {
    // Beside, above the lamp, and a long bar whose sphere reaches far into the cone while the bar does not.
    for (const MeshInstance& caster :
         {body(kBall, {4.0, 0.0, 3.0}, glm::dvec3(1.0)), body(kBall, {0.0, 0.0, 9.0}, glm::dvec3(1.0)),
          body(kBox, {0.0, 3.0, 3.0}, {12.0, 0.3, 0.3}),
          body(kBall, {0.0, 0.0, 3.0}, glm::dvec3(1.0), false)}) {
        Scene scene = lampOverFloor(20.0);
        scene.instances.push_back(caster);
        EXPECT_TRUE(plan(scene).maps.empty());
    }
    Scene scene = lampOverFloor(20.0);
    scene.instances.push_back(body(kBall, {0.0, 0.0, 2.0}, glm::dvec3(0.6)));
    scene.beams.front().castsShadow = false;
    EXPECT_TRUE(plan(scene).maps.empty());
}

TEST(ShadowPlan, OnlyTheCastersOfALampAreDrawnForIt) {
    Scene scene = lampOverFloor(20.0);
    scene.instances.push_back(body(kBall, {0.0, 0.0, 2.0}, glm::dvec3(0.6)));
    scene.instances.push_back(body(kBall, {8.0, 0.0, 2.0}, glm::dvec3(0.6)));
    Beam second = scene.beams.front();
    second.lensPositionM = {8.0, 0.0, 6.0};
    scene.beams.push_back(second);
    const ShadowPlan p = plan(scene);
    ASSERT_EQ(p.maps.size(), 2u);
    EXPECT_EQ(p.maps[0].faces.front().casters, std::vector<int>{1});
    EXPECT_EQ(p.maps[1].faces.front().casters, std::vector<int>{2});
}

TEST(ShadowPlan, ALampReachesFromTheNearestToTheFarthestSurfaceInItsCone) {
    Scene scene = lampOverFloor(20.0);
    scene.instances.push_back(body(kBall, {0.0, 0.0, 2.0}, glm::dvec3(0.6)));
    scene.instances.push_back(body(kBox, {30.0, 0.0, -20.0}, glm::dvec3(1.0)));
    const ShadowPlan p = plan(scene);
    ASSERT_TRUE(p.reach.front().has_value());
    EXPECT_NEAR(p.reach.front()->nearM, 3.7, 1e-9);
    EXPECT_NEAR(p.reach.front()->farM, 6.0, 1e-9);
    scene.instances.erase(scene.instances.begin(), scene.instances.begin() + 2);
    EXPECT_FALSE(plan(scene).reach.front().has_value());
}

TEST(ShadowPlan, AReachThatBeginsAtTheLensLeavesNothingOut) {
    Scene scene = lampOverFloor(20.0);
    scene.beams.front().lensRadiusM = 0.1;
    scene.instances.push_back(body(kBox, {0.0, 0.0, 6.0}, glm::dvec3(1.0)));
    const double apexToLensM = render::beamShape(scene.beams.front()).apexToLensM;
    EXPECT_LE(plan(scene).reach.front()->nearM, apexToLensM);
}

TEST(ShadowPlan, WideLampsLookAtEachSideWhereSomethingStands) {
    Scene scene = lampOverFloor(85.0);
    scene.instances.push_back(body(kBall, {4.0, 0.0, 5.5}, glm::dvec3(1.0)));
    scene.instances.push_back(body(kBall, {0.0, 0.0, 2.0}, glm::dvec3(1.0)));
    const ShadowPlan p = plan(scene);
    ASSERT_EQ(p.maps.size(), 1u);
    EXPECT_TRUE(p.maps.front().isWide);
    ASSERT_EQ(p.maps.front().faces.size(), 2u);
    EXPECT_EQ(p.maps.front().faces[0].face, 0);
    EXPECT_EQ(p.maps.front().faces[0].casters, std::vector<int>{2});
    EXPECT_EQ(p.maps.front().faces[1].face, 1);
    EXPECT_EQ(p.maps.front().faces[1].casters, std::vector<int>{1});
    EXPECT_GE(p.reach.front()->farM, 20.0);
}

TEST(ShadowPlan, ABodyAcrossASeamIsInBothFaces) {
    Scene scene = lampOverFloor(88.0);
    scene.instances.push_back(body(kBall, {3.0, 0.0, 3.0}, glm::dvec3(1.0)));
    const ShadowPlan p = plan(scene);
    ASSERT_EQ(p.maps.size(), 1u);
    EXPECT_EQ(p.maps.front().faces.size(), 2u);
}

TEST(ShadowPlan, TilesAreAsFineAsThePictureShowsThem) {
    Scene scene = lampOverFloor(20.0);
    scene.instances.push_back(body(kBox, {0.0, 0.0, 3.0}, {0.4, 0.4, 0.4}));
    const int usual = onlyFace(plan(scene)).sizeTexels;
    // 0.4 m at 2.8 m are 0.14 units of tangent; 6 m from the lamp and 10 m from the camera, two texels to a
    // pixel of 1 mrad make some 170.
    EXPECT_EQ(usual, 256);
    EXPECT_EQ(onlyFace(plan(scene, {kFromTheHouse.cameraM, 0.004})).sizeTexels, 64);
    EXPECT_EQ(onlyFace(plan(scene, {{0.0, -40.0, 2.0}, 0.001})).sizeTexels, 64);
    EXPECT_GT(onlyFace(plan(scene, {{0.0, -2.0, 1.0}, 0.001})).sizeTexels, usual);
    // A wall in the beam fills the whole cone.
    scene.instances.push_back(body(kBox, {0.0, 0.0, 3.0}, {20.0, 20.0, 0.1}));
    EXPECT_EQ(onlyFace(plan(scene)).sizeTexels, 1024);
}

TEST(ShadowPlan, ADimLampHasCoarserTiles) {
    Scene scene = lampOverFloor(20.0);
    scene.instances.push_back(body(kBox, {0.0, 0.0, 3.0}, {0.4, 0.4, 0.4}));
    scene.beams.push_back(scene.beams.front());
    scene.beams.back().intensityCd = 0.001;
    const ShadowPlan p = plan(scene);
    ASSERT_EQ(p.maps.size(), 2u);
    EXPECT_EQ(p.maps[1].faces.front().sizeTexels * 2, p.maps[0].faces.front().sizeTexels);
}

std::int64_t texelsOf(const ShadowPlan& p) {
    std::int64_t sum = 0;
    for (const auto& map : p.maps) {
        for (const auto& face : map.faces) sum += std::int64_t{face.sizeTexels} * face.sizeTexels;
    }
    return sum;
}

Scene manyLamps(int count) {
    Scene scene = lampOverFloor(20.0);
    scene.instances.push_back(body(kBox, {0.0, 0.0, 3.0}, {20.0, 20.0, 0.1}));
    const Beam first = scene.beams.front();
    scene.beams.clear();
    for (int i = 0; i < count; ++i) {
        scene.beams.push_back(first);
        scene.beams.back().intensityCd = 1000.0 + i;
    }
    return scene;
}

TEST(ShadowPlan, ManyLampsShareTheMemory) {
    for (const int count : {16, 17, 256, 1000}) {
        const ShadowPlan p = plan(manyLamps(count));
        EXPECT_EQ(p.maps.size(), static_cast<std::size_t>(count));
        EXPECT_TRUE(p.leftOut.empty());
        EXPECT_LE(texelsOf(p), render::kMostShadowTexels);
        EXPECT_GT(texelsOf(p), render::kMostShadowTexels / 8) << "and use it";
    }
}

TEST(ShadowPlan, BeyondTheMemoryTheDimmestShineThroughAndThePlanSaysSo) {
    constexpr int kMost = 4096;
    const ShadowPlan p = plan(manyLamps(kMost + 10));
    EXPECT_EQ(p.maps.size(), static_cast<std::size_t>(kMost));
    EXPECT_LE(texelsOf(p), render::kMostShadowTexels);
    std::vector<int> leftOut = p.leftOut;
    std::sort(leftOut.begin(), leftOut.end());
    std::vector<int> dimmest(10);
    std::iota(dimmest.begin(), dimmest.end(), 0);
    EXPECT_EQ(leftOut, dimmest);
}

TEST(ShadowPlan, ABodyMayBeSheared) {
    Scene scene = lampOverFloor(20.0);
    MeshInstance sheared = body(kBox, {0.0, 0.0, 3.0}, glm::dvec3(1.0));
    // One corner of the sheared box is in the cone; the length of no single edge tells so.
    sheared.worldFromMesh[0] = {2.0, 2.0, 0.0, 0.0};
    sheared.worldFromMesh[1] = {2.0, 2.0, 0.1, 0.0};
    sheared.worldFromMesh[2] = {2.0, 2.0, 0.0, 0.0};
    sheared.worldFromMesh[3] = {3.5, 3.5, 3.0, 1.0};
    scene.instances.push_back(sheared);
    EXPECT_EQ(plan(scene).maps.size(), 1u);
}

}  // namespace
}  // namespace hazer::test
