// The camera under a hand: its limits, and that what is under the hand stays there.
#include "app/orbit_camera.h"

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>
#include <limits>

#include "app/window_picking.h"
#include "render/camera.h"

namespace hazer::app {
namespace {

constexpr glm::dvec2 kPicture{1600.0, 900.0};

render::Camera cameraAt(const glm::dvec3& positionM, const glm::dvec3& targetM) {
    render::Camera camera;
    camera.positionM = positionM;
    camera.targetM = targetM;
    return camera;
}

void expectNear(const glm::dvec3& actual, const glm::dvec3& expected) {
    EXPECT_NEAR(glm::distance(actual, expected), 0.0, 1e-9)
        << "(" << actual.x << ", " << actual.y << ", " << actual.z << ")";
}

TEST(OrbitCamera, standsWhereTheShowPutsIt) {
    const render::Camera saved = cameraAt({3.5, -10.0, 2.2}, {0.2, 1.0, 2.9});
    const render::Camera camera = OrbitCamera(saved).camera();
    expectNear(camera.positionM, saved.positionM);
    expectNear(camera.targetM, saved.targetM);
    EXPECT_DOUBLE_EQ(camera.verticalFovRad, saved.verticalFovRad);
}

TEST(OrbitCamera, turnsTheWorldWithTheHand) {
    OrbitCamera orbit(cameraAt({0.0, -10.0, 0.0}, {0.0, 0.0, 0.0}));
    orbit.orbit({0.5, 0.0});  // a quarter turn: what was in front goes to the right
    expectNear(orbit.camera().positionM, {-10.0, 0.0, 0.0});
    orbit.orbit({0.0, 0.25});
    EXPECT_NEAR(orbit.camera().positionM.z, 10.0 * glm::sin(glm::quarter_pi<double>()), 1e-9);
    EXPECT_NEAR(orbit.distanceM(), 10.0, 1e-9);
}

TEST(OrbitCamera, neverFlipsAtThePoles) {
    for (const double direction : {1.0, -1.0}) {
        OrbitCamera orbit(cameraAt({0.0, -10.0, 0.0}, {0.0, 0.0, 0.0}));
        for (int i = 0; i < 100; ++i) {
            orbit.orbit({0.0, 0.1 * direction});
            const glm::dmat3 view = render::worldFromView(orbit.camera());
            EXPECT_GT(view[1].z, 0.0) << "up points down";
            EXPECT_NEAR(view[0].x, 1.0, 1e-9) << "the picture turned over";
        }
        EXPECT_GT(direction * orbit.camera().positionM.z, 9.9);
    }
}

TEST(OrbitCamera, looksDownFromAboveWithoutNaN) {
    const render::Camera camera = OrbitCamera(cameraAt({1.0, 2.0, 9.0}, {1.0, 2.0, 0.0})).camera();
    expectNear(camera.positionM, {1.0, 2.0, 9.0});
    EXPECT_LT(camera.targetM.z, 0.01);
}

TEST(OrbitCamera, dolliesBetweenItsLimits) {
    OrbitCamera orbit(cameraAt({0.0, -10.0, 0.0}, {0.0, 0.0, 0.0}));
    orbit.dolly(1.0);
    EXPECT_NEAR(orbit.distanceM(), 9.0, 1e-9);
    orbit.dolly(-1.0);
    EXPECT_NEAR(orbit.distanceM(), 10.0, 1e-9);
    orbit.dolly(1000.0);
    EXPECT_EQ(orbit.distanceM(), OrbitCamera::kMinDistanceM);
    orbit.dolly(-1000.0);
    EXPECT_EQ(orbit.distanceM(), OrbitCamera::kMaxDistanceM);
}

TEST(OrbitCamera, startsFromACameraInItsOwnTarget) {
    const render::Camera camera = OrbitCamera(cameraAt({1.0, 2.0, 3.0}, {1.0, 2.0, 3.0})).camera();
    expectNear(camera.positionM, {1.0, 2.0, 3.0});
    EXPECT_NEAR(glm::distance(camera.positionM, camera.targetM), OrbitCamera::kMinDistanceM, 1e-12);
}

TEST(OrbitCamera, panKeepsTheTargetUnderTheHand) {
    OrbitCamera orbit(cameraAt({3.0, -8.0, 4.0}, {0.5, 1.0, 2.0}));
    const glm::dvec3 graspedM = orbit.camera().targetM;
    const glm::dvec2 drag{0.2, -0.1};
    orbit.pan(drag);
    const auto place = placeInPicture(orbit.camera(), kPicture, graspedM);
    ASSERT_TRUE(place);
    EXPECT_NEAR(place->x, 0.5 * kPicture.x + drag.x * kPicture.y, 1e-6);
    EXPECT_NEAR(place->y, 0.5 * kPicture.y + drag.y * kPicture.y, 1e-6);
}

TEST(OrbitCamera, framesABallInWideAndTallPictures) {
    const glm::dvec3 centreM{1.0, 2.0, 3.0};
    for (const glm::dvec2 picture : {kPicture, glm::dvec2(kPicture.y, kPicture.x)}) {
        OrbitCamera orbit(cameraAt({0.0, -50.0, 10.0}, {0.0, 0.0, 0.0}));
        orbit.frame(centreM, 2.0, picture.x / picture.y);
        const render::Camera camera = orbit.camera();
        const glm::dmat3 view = render::worldFromView(camera);
        const auto right = placeInPicture(camera, picture, centreM + 2.0 * view[0]);
        const auto top = placeInPicture(camera, picture, centreM + 2.0 * view[1]);
        ASSERT_TRUE(right && top);
        EXPECT_LT(right->x, picture.x);
        EXPECT_GT(top->y, 0.0);
        // It fills most of the narrower edge.
        EXPECT_GT(std::max(right->x / picture.x, 1.0 - top->y / picture.y), 0.85);
    }
}

TEST(OrbitCamera, framesFromAboveTheFloor) {
    OrbitCamera orbit(cameraAt({0.0, -10.0, 1.0}, {0.0, 0.0, 4.0}));
    orbit.frame({0.0, 0.0, 3.0}, 8.0, 1.6);
    EXPECT_GT(orbit.camera().positionM.z, 3.0);
}

TEST(OrbitCamera, fieldOfViewStaysUsable) {
    OrbitCamera orbit{render::Camera()};
    orbit.setVerticalFov(100.0);
    EXPECT_EQ(orbit.camera().verticalFovRad, OrbitCamera::kMaxFovRad);
    orbit.setVerticalFov(0.0);
    EXPECT_EQ(orbit.camera().verticalFovRad, OrbitCamera::kMinFovRad);
}

}  // namespace
}  // namespace hazer::app
