// The resolution that follows the time of the picture, tried on machines whose time goes with the pixels.
#include "app/window_resolution.h"

#include <gtest/gtest.h>

namespace hazer::app {
namespace {

/// Lets it see pictures of a machine that takes `fullMs` for one at full resolution.
void watch(WindowResolution& resolution, double fullMs, int pictures = 400) {
    for (int i = 0; i < pictures; ++i) {
        resolution.add(fullMs * resolution.factor() * resolution.factor());
    }
}

TEST(WindowResolution, isFullAfterABlinkOnAFastMachine) {
    WindowResolution resolution;
    watch(resolution, 16.0, 10);
    EXPECT_EQ(resolution.factor(), 1.0);
}

TEST(WindowResolution, goesCoarserUntilThePictureIsFastEnough) {
    WindowResolution resolution;
    watch(resolution, 400.0);
    const double timeMs = 400.0 * resolution.factor() * resolution.factor();
    EXPECT_LT(timeMs, WindowResolution::kSlowMs);
    EXPECT_GT(timeMs, 0.5 * WindowResolution::kSlowMs);
}

TEST(WindowResolution, settles) {
    WindowResolution resolution;
    watch(resolution, 170.0);
    const double factor = resolution.factor();
    for (int i = 0; i < 100; ++i) {
        watch(resolution, 170.0, 1);
        EXPECT_EQ(resolution.factor(), factor);
    }
}

TEST(WindowResolution, comesBackWhenTheSceneGetsLighter) {
    WindowResolution resolution;
    watch(resolution, 400.0);
    watch(resolution, 20.0);
    EXPECT_EQ(resolution.factor(), 1.0);
}

TEST(WindowResolution, stopsAtItsCoarsest) {
    WindowResolution resolution;
    watch(resolution, 1e6);
    EXPECT_EQ(resolution.factor(), WindowResolution::kMinFactor);
}

TEST(WindowResolution, doesNotWaitForManyVerySlowPictures) {
    WindowResolution resolution;
    watch(resolution, 8000.0, 2);
    EXPECT_EQ(resolution.factor(), WindowResolution::kMinFactor);
}

TEST(WindowResolution, waitsForTimes) {
    WindowResolution resolution;
    watch(resolution, 0.0);
    EXPECT_EQ(resolution.factor(), WindowResolution().factor());
}

TEST(WindowResolution, oneSlowPictureChangesNothing) {
    WindowResolution resolution;
    watch(resolution, 16.0);
    for (int i = 0; i < 100; ++i) resolution.add(i % 7 == 0 ? 3000.0 : 16.0);
    EXPECT_EQ(resolution.factor(), 1.0);
}

TEST(WindowResolution, aPersonsChoiceStands) {
    WindowResolution resolution;
    resolution.setFactor(0.5);
    watch(resolution, 4000.0);
    EXPECT_EQ(resolution.factor(), 0.5);
    resolution.setFactor(7.0);
    EXPECT_EQ(resolution.factor(), 1.0);
    resolution.setAutomatic(true);
    watch(resolution, 4000.0);
    EXPECT_LT(resolution.factor(), 0.5);
}

TEST(WindowResolution, drawsAtLeastOnePixel) {
    WindowResolution resolution;
    resolution.setFactor(0.25);
    EXPECT_EQ(resolution.drawnSize({1600, 900}), glm::ivec2(400, 225));
    EXPECT_EQ(resolution.drawnSize({1, 1}), glm::ivec2(1, 1));
}

}  // namespace
}  // namespace hazer::app
