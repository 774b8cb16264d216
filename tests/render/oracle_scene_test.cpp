// The oracle of a whole scene: gobos, bodies in the way and light on surfaces, against what geometry says.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "render/oracle/scene_oracle.h"

namespace hazer::test {
namespace {

using namespace render;
using namespace render::oracle;

constexpr double kPi = 3.14159265358979323846;
constexpr int kSize = 100;
constexpr double kHalf = 15.0 * kPi / 180.0;

/// A point source of 1000 cd at 6 m that shines down 15 degrees to each side, isotropic haze, no extinction.
Scene lampAbove() {
    Scene scene;
    Beam beam;
    beam.lensPositionM = {0.0, 0.0, 6.0};
    beam.lensRadiusM = 0.0;
    beam.fieldAngleRad = 2.0 * kHalf;
    beam.edge = BeamEdge::kFlat;
    beam.intensityCd = 1000.0;
    scene.beams.push_back(beam);
    scene.haze.extinctionPerM = 0.0f;
    scene.haze.scatteringPerM = 0.01f;
    scene.haze.phase = {0.0f, 0.0f, 1.0f};
    return scene;
}

/// From the side, level, at the height of 2 m: 4 m below the lamp.
Camera fromTheSide() {
    return {{-10.0, 0.0, 2.0}, {0.0, 0.0, 2.0}, {0.0, 0.0, 1.0}, 0.6};
}

double closedForm(double u0, double u1) {
    return 0.01 * 1000.0 * (u1 - u0) / (4.0 * kPi * 4.0);
}

MeshInstance box(const glm::dvec3& centerM, const glm::dvec3& sizeM) {
    MeshInstance instance;
    instance.mesh = 0;
    instance.worldFromMesh = glm::scale(glm::translate(glm::dmat4(1.0), centerM), sizeM);
    return instance;
}

Library oneBox() {
    Library library;
    library.meshes.push_back(makeBox());
    return library;
}

double airInTheMiddle(const Scene& scene, Library library) {
    const SceneOracle oracle(scene, fromTheSide(), kSize, kSize, std::move(library));
    return oracle.air(0.5 * kSize, 0.5 * kSize).y;
}

TEST(OracleScene, plainBeam) {
    EXPECT_NEAR(airInTheMiddle(lampAbove(), {}) / closedForm(-kHalf, kHalf), 1.0, 1e-6);
}

TEST(OracleScene, farFromTheOriginNothingIsLost) {
    Scene scene = lampAbove();
    const glm::dvec3 far(1e5, -2e5, 3e3);
    scene.beams.front().lensPositionM += far;
    scene.instances.push_back(box(far + glm::dvec3(1.0, 0.0, 4.0), {2.0, 2.0, 0.1}));
    Camera camera = fromTheSide();
    camera.positionM += far;
    camera.targetM += far;
    const SceneOracle oracle(scene, camera, kSize, kSize, oneBox());
    EXPECT_NEAR(oracle.air(50.0, 50.0).y / closedForm(-kHalf, 0.0), 1.0, 1e-4);
}

TEST(OracleScene, aBodyShadesWhatLiesBehindIt) {
    // A plate 2 m below the lamp over all x > 0: half of the light 2 m further down is gone.
    Scene scene = lampAbove();
    scene.instances.push_back(box({1.0, 0.0, 4.0}, {2.0, 2.0, 1e-3}));
    EXPECT_NEAR(airInTheMiddle(scene, oneBox()) / closedForm(-kHalf, 0.0), 1.0, 1e-4);
    // 0.1 m wide in the middle, 2 m below the lamp: 0.2 m wide 4 m below.
    scene.instances.front() = box({0.0, 0.0, 4.0}, {0.1, 2.0, 1e-3});
    const double hidden = 2.0 * std::atan(0.05 / 2.0);
    EXPECT_NEAR(airInTheMiddle(scene, oneBox()) / closedForm(-kHalf, kHalf - hidden), 1.0, 1e-4);
}

TEST(OracleScene, whatCastsNoShadowOrLiesBelowShadesNothing) {
    Scene scene = lampAbove();
    scene.instances.push_back(box({1.0, 0.0, 1.0}, {2.0, 2.0, 0.1}));
    EXPECT_NEAR(airInTheMiddle(scene, oneBox()) / closedForm(-kHalf, kHalf), 1.0, 1e-6);
    scene.instances.front() = box({1.0, 0.0, 4.0}, {2.0, 2.0, 0.1});
    scene.instances.front().castsShadow = false;
    EXPECT_NEAR(airInTheMiddle(scene, oneBox()) / closedForm(-kHalf, kHalf), 1.0, 1e-6);
    scene.instances.front().castsShadow = true;
    scene.beams.front().castsShadow = false;
    EXPECT_NEAR(airInTheMiddle(scene, oneBox()) / closedForm(-kHalf, kHalf), 1.0, 1e-6);
}

TEST(OracleScene, aRayEndsAtWhatItMeets) {
    // A wall in the middle of the beam, seen from -x; its own shadow falls beyond it.
    Scene scene = lampAbove();
    scene.instances.push_back(box({0.05, 0.0, 2.0}, {0.1, 4.0, 4.0}));
    EXPECT_NEAR(airInTheMiddle(scene, oneBox()) / closedForm(-kHalf, 0.0), 1.0, 1e-4);
}

/// Open where x > 0 and y > 0 as the picture is seen.
GoboPicture quarter(int size) {
    std::vector<std::uint8_t> rgba;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const std::uint8_t value = x >= size / 2 && y < size / 2 ? 255 : 0;
            rgba.insert(rgba.end(), {value, value, value, 255});
        }
    }
    return GoboPicture(rgba, size);
}

TEST(OracleGobo, liesAsThePictureIsSeen) {
    const GoboPicture gobo = quarter(64);
    EXPECT_TRUE(gobo.isGrey());
    EXPECT_EQ(gobo.transmission({0.5, 0.5}, 1.0).y, 1.0);
    EXPECT_EQ(gobo.transmission({-0.5, 0.5}, 1.0).y, 0.0);
    EXPECT_EQ(gobo.transmission({0.5, -0.5}, 1.0).y, 0.0);
    EXPECT_NEAR(gobo.transmission({0.0, 0.5}, 1.0).y, 0.5, 1e-12);
    EXPECT_NEAR(gobo.transmission({0.0, 0.0}, 1e9).y, 0.25, 1e-12) << "as blurred as it gets";
    EXPECT_EQ(gobo.transmission({1e30, 1e30}, 1.0), glm::dvec3(0.0)) << "beyond the picture";
    EXPECT_NEAR(gobo.transmission({0.0, 0.0}, 16.0).y, 0.25, 1e-12);
}

TEST(OracleGobo, cutsTheBeamAsTheLampTurnsIt) {
    Scene scene = lampAbove();
    scene.beams.front().gobo = 0;
    // The ray runs along world x through the middle of the gobo, along its lower rim of y = 0: turned back by
    // 45 degrees it passes from (-, -) to (+, +), so the half beyond the axis is open.
    scene.beams.front().goboRotationRad = -45.0 * kPi / 180.0;
    Library library;
    library.gobos.push_back(quarter(512));
    const double half = airInTheMiddle(scene, library);
    EXPECT_NEAR(half / closedForm(0.0, kHalf), 1.0, 3e-2);  // a pixel is 8 texels wide
    // Light from a lamp that looks down has its picture's right at +x and up at +y: turned the other way the
    // ray passes through the closed quarters only.
    scene.beams.front().goboRotationRad = 45.0 * kPi / 180.0;
    EXPECT_LT(airInTheMiddle(scene, library), 0.03 * closedForm(0.0, kHalf));
}

// A web that holds a soft profile is that profile.
TEST(OracleScene, aWebStandsForTheProfile) {
    const double width = 0.15;
    IesWeb web;
    for (int row = 0; row < kWebThetas; ++row) {
        const double theta = kPi * std::pow(row / (kWebThetas - 1.0), 2.0);
        // Twice as bright on the side of +X as on the other.
        for (int column = 0; column < kWebAzimuths; ++column) {
            const double side = 0.75 + 0.25 * std::cos(2.0 * kPi * column / kWebAzimuths);
            web.relative.push_back(static_cast<float>(side * std::exp(-std::pow(theta / width, 2.0))));
        }
    }
    web.peakCd = 1000.0;
    web.cutHalfAngleRad = 0.5;
    web.beamHalfAngleRad = width * std::sqrt(std::log(2.0));
    web.fieldHalfAngleRad = 0.3;
    Scene scene = lampAbove();
    scene.beams.front().web = 0;
    Library library;
    library.webs.push_back(web);
    BeamModel soft;
    soft.cutHalfAngleRad = 0.5;
    soft.beamHalfAngleRad = web.beamHalfAngleRad;
    soft.exponent = 2.0;
    const HazeModel haze{0.0, scene.haze.scatteringPerM, 0.0, 0.0, 1.0};
    // The ray goes from -x to +x, so it sees the bright and the dim half: 3/4 of the whole on average.
    const double whole = 1000.0 * airRadiance(soft, haze, {{-10.0, 0.0, -4.0}, {1.0, 0.0, 0.0}, 1e5});
    EXPECT_NEAR(airInTheMiddle(scene, library) / whole, 0.75, 1e-4);
    // Up to the axis only the dim half.
    scene.instances.push_back(box({0.05, 0.0, 2.0}, {0.1, 4.0, 4.0}));
    library.meshes.push_back(makeBox());
    EXPECT_NEAR(airInTheMiddle(scene, library) / whole, 0.25, 1e-4);
}

TEST(OracleScene, unevenHazeIsWeighedWhereItIs) {
    Library library;
    library.density = [](const glm::dvec3& place) { return place.x < 0.0 ? 2.0 : 0.5; };
    EXPECT_NEAR(airInTheMiddle(lampAbove(), library) / closedForm(-kHalf, kHalf), 1.25, 1e-3);
}

TEST(OracleScene, lightOnTheFloor) {
    Scene scene = lampAbove();
    scene.haze.extinctionPerM = 0.05f;
    scene.haze.scatteringPerM = 0.0f;
    scene.ambient.illuminanceLx = 2.0f;
    MeshInstance floor = box({0.0, 0.0, -0.5}, {40.0, 40.0, 1.0});
    floor.material.albedo = Color(0.5f, 0.25f, 0.125f);
    floor.material.specular = 0.0f;
    scene.instances.push_back(floor);
    // Looks at the point (1, 0, 0) from above.
    const Camera camera{{1.0, 0.0, 3.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.5};
    const SceneOracle oracle(scene, camera, kSize, kSize, oneBox());
    const double r = std::hypot(6.0, 1.0);
    const double lux = 1000.0 * (6.0 / r) / (r * r) * std::exp(-0.05 * r) + 2.0;
    const glm::dvec3 got = oracle.surface(50.0, 50.0);
    EXPECT_NEAR(got.x, 0.5 * lux / kPi * std::exp(-0.05 * 3.0), 1e-4 * got.x);
    EXPECT_NEAR(got.z / got.x, 0.25, 1e-6);
    EXPECT_TRUE(oracle.isClearOfOutlines(50.0, 50.0));
    EXPECT_EQ(oracle.air(50.0, 50.0).y, 0.0);
}

TEST(OracleScene, aShinyFloorReflectsItsShare) {
    // Where the lamp's mirror image is seen: straight below, looking straight down.
    Scene scene = lampAbove();
    scene.haze.scatteringPerM = 0.0f;
    MeshInstance floor = box({0.0, 0.0, -0.5}, {40.0, 40.0, 1.0});
    floor.material = {Color(0.0f), 0.1f, 50.0f};
    scene.instances.push_back(floor);
    const Camera camera{{0.0, 0.0, 3.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.5};
    const SceneOracle oracle(scene, camera, kSize, kSize, oneBox());
    EXPECT_NEAR(oracle.surface(50.0, 50.0).y, 1000.0 / 36.0 * 0.1 * 52.0 / (8.0 * kPi), 1e-3);
}

TEST(OracleScene, knowsOutlines) {
    Scene scene = lampAbove();
    scene.instances.push_back(box({0.0, 0.0, 2.0}, {1.0, 1.0, 1.0}));
    const SceneOracle oracle(scene, fromTheSide(), kSize, kSize, oneBox());
    const double pixel = 2.0 * std::tan(0.3) / kSize;
    const double edge = 50.0 + 0.5 / 9.5 / pixel;
    EXPECT_TRUE(oracle.isClearOfOutlines(50.0, 50.0));
    EXPECT_FALSE(oracle.isClearOfOutlines(50.0, edge + 0.003));
    EXPECT_TRUE(oracle.isClearOfOutlines(50.0, edge + 1.0));
    EXPECT_EQ(oracle.surface(50.0, edge + 3.0).y, 0.0);
}

}  // namespace
}  // namespace hazer::test
