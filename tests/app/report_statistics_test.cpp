// The figures of the reports, on numbers whose answers are known.
#include "app/report/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace hazer::app {
namespace {

using render::FloatImage;

/// Grey pixels.
FloatImage row(const std::vector<float>& values) {
    FloatImage image{static_cast<int>(values.size()), 1, {}};
    for (const float value : values) image.rgb.insert(image.rgb.end(), {value, value, value});
    return image;
}

TEST(Median, theMiddle) {
    EXPECT_EQ(median({3.0}), 3.0);
    EXPECT_EQ(median({9.0, 1.0, 5.0}), 5.0);
    EXPECT_EQ(median({4.0, 1.0, 3.0, 2.0}), 3.0);
}

TEST(PictureError, ofTheSamePictureIsNone) {
    const FloatImage image = row({1.0f, 2.0f, 0.0f});
    const PictureError error = pictureError(image, image);
    EXPECT_EQ(error.litPixels, 2u);
    EXPECT_EQ(error.rmsRel, 0.0);
    EXPECT_EQ(error.maxRel, 0.0);
    EXPECT_EQ(error.unlitMaxRel, 0.0);
}

TEST(PictureError, isRelativeToTheReferencesRms) {
    // Light 3 and 4: rms sqrt(12.5). Errors 0.3 and 0: rms sqrt(0.045).
    const PictureError error = pictureError(row({3.3f, 4.0f}), row({3.0f, 4.0f}));
    EXPECT_NEAR(error.rmsRel, std::sqrt(0.045 / 12.5), 1e-6);
    EXPECT_NEAR(error.maxRel, 0.3 / std::sqrt(12.5), 1e-6);
    EXPECT_NEAR(error.p99Rel, error.maxRel, 1e-12);
}

TEST(PictureError, aFactorOnEveryPixelIsThatError) {
    std::vector<float> light, more;
    for (int i = 1; i <= 200; ++i) {
        light.push_back(static_cast<float>(i));
        more.push_back(1.25f * static_cast<float>(i));
    }
    EXPECT_NEAR(pictureError(row(more), row(light)).rmsRel, 0.25, 1e-6);
}

TEST(PictureError, ninetyNineOfAHundredLeaveOneOut) {
    std::vector<float> light(100, 1.0f), wrong(100, 1.0f);
    wrong[17] = 3.0f;
    PictureError error = pictureError(row(wrong), row(light));
    EXPECT_NEAR(error.p99Rel, 0.0, 1e-12);
    EXPECT_NEAR(error.maxRel, 2.0, 1e-6);
    wrong[18] = 2.0f;
    error = pictureError(row(wrong), row(light));
    EXPECT_NEAR(error.p99Rel, 1.0, 1e-6);
}

TEST(PictureError, darkPixelsCountOnTheirOwn) {
    // 0.5e-4 of the brightest is not lit.
    const PictureError error = pictureError(row({1.0f, 0.1f}), row({1.0f, 0.5e-4f}));
    EXPECT_EQ(error.litPixels, 1u);
    EXPECT_EQ(error.rmsRel, 0.0);
    EXPECT_NEAR(error.unlitMaxRel, 0.1, 1e-4);
}

TEST(PictureError, colourCounts) {
    const FloatImage reference{1, 1, {1.0f, 0.0f, 0.0f}};
    const FloatImage picture{1, 1, {0.0f, 1.0f, 0.0f}};
    EXPECT_NEAR(pictureError(picture, reference).rmsRel, std::sqrt(2.0), 1e-6);
}

TEST(PictureError, noNumberIsAnInfiniteError) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const PictureError error = pictureError(row({nan, 1.0f}), row({1.0f, 1.0f}));
    EXPECT_TRUE(std::isinf(error.maxRel));
    EXPECT_TRUE(std::isinf(error.rmsRel));
    EXPECT_TRUE(std::isinf(pictureError(row({nan, 1.0f}), row({0.0f, 1.0f})).unlitMaxRel));
}

TEST(PictureError, ofADarkReferenceIsNone) {
    EXPECT_EQ(pictureError(row({1.0f}), row({0.0f})).litPixels, 0u);
}

TEST(TimeAtError, betweenPointsBothLogarithmsAreLinear) {
    // Ten times the time, a tenth of the error.
    const std::vector<TimedError> measured{{1.0, 1e-1}, {10.0, 1e-2}, {100.0, 1e-3}};
    const TimeAtError exact = timeAtError(measured, 1e-2);
    EXPECT_TRUE(exact.isReached);
    EXPECT_NEAR(exact.ms, 10.0, 1e-9);
    EXPECT_NEAR(timeAtError(measured, std::sqrt(1e-5)).ms, std::sqrt(1e3), 1e-9);
}

TEST(TimeAtError, beforeTheFirstPointIsTheFirst) {
    const TimeAtError early = timeAtError(std::vector<TimedError>{{1.0, 1e-1}, {10.0, 1e-2}}, 0.5);
    EXPECT_TRUE(early.isReached);
    EXPECT_EQ(early.ms, 1.0);
}

TEST(TimeAtError, notReachedTellsTheLast) {
    const TimeAtError never = timeAtError(std::vector<TimedError>{{1.0, 1e-1}, {10.0, 1e-2}}, 1e-3);
    EXPECT_FALSE(never.isReached);
    EXPECT_EQ(never.ms, 10.0);
    EXPECT_EQ(never.rmsRel, 1e-2);
}

TEST(TimeAtError, aPointWithoutAnyError) {
    const TimeAtError exact = timeAtError(std::vector<TimedError>{{1.0, 1e-1}, {10.0, 0.0}}, 1e-3);
    EXPECT_TRUE(exact.isReached);
    EXPECT_EQ(exact.ms, 10.0);
}

}  // namespace
}  // namespace hazer::app
