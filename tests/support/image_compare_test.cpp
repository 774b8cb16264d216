#include "tests/support/image_compare.h"

#include <gtest/gtest.h>

#include <limits>

namespace hazer::test {
namespace {

render::FloatImage grey(float value) {
    return {10, 10, std::vector<float>(300, value)};
}

constexpr Tolerance kTolerance{0.1, 0.01, 0.02, 5.0};

TEST(CompareImages, SamePicturesAreZeroApart) {
    const Comparison result = compareImages(grey(3.0f), grey(3.0f), Tolerance{});
    EXPECT_EQ(result.shareBeyond, 0.0);
    EXPECT_EQ(result.worstThresholds, 0.0);
}

TEST(CompareImages, ThresholdIsAbsolutePlusRelative) {
    // 100: the threshold is 0.1 + 1.
    EXPECT_NEAR(compareImages(grey(102.2f), grey(100.0f), kTolerance).worstThresholds, 2.0, 1e-4);
}

TEST(CompareImages, ShareCountsPixelsNotValues) {
    render::FloatImage actual = grey(1.0f);
    for (std::size_t i = 0; i < 6; ++i) actual.rgb[30 + i] = 1.2f;
    const Comparison result = compareImages(actual, grey(1.0f), kTolerance);
    EXPECT_DOUBLE_EQ(result.shareBeyond, 0.02);
    EXPECT_TRUE(result.within(kTolerance));
    actual.rgb[0] = 1.2f;
    EXPECT_FALSE(compareImages(actual, grey(1.0f), kTolerance).within(kTolerance));
}

TEST(CompareImages, OnePixelBeyondTheCeilingIsTooMany) {
    render::FloatImage actual = grey(1.0f);
    actual.rgb[3 * (7 * 10 + 4) + 2] = 2.0f;
    const Comparison result = compareImages(actual, grey(1.0f), kTolerance);
    EXPECT_EQ(result.worstX, 4);
    EXPECT_EQ(result.worstY, 7);
    EXPECT_FALSE(result.within(kTolerance));
}

TEST(CompareImages, WhatIsNotFiniteIsNeverWithin) {
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        render::FloatImage actual = grey(1.0f);
        actual.rgb[299] = bad;
        EXPECT_FALSE(compareImages(actual, grey(1.0f), {1e9, 1e9, 1.0, 1e9}).within({1e9, 1e9, 1.0, 1e9}));
    }
}

TEST(DifferenceImage, IsAbsoluteAndAmplified) {
    EXPECT_FLOAT_EQ(differenceImage(grey(1.0f), grey(1.25f), 10.0f).rgb[5], 2.5f);
}

}  // namespace
}  // namespace hazer::test
