// Gobos as pictures of what they let through.
#include "render/gobo_picture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/error.h"
#include "tests/render/gobo_pictures.h"

namespace hazer::test {
namespace {

using render::GoboPicture;
using render::kGoboLevels;
using render::kGoboSize;

std::vector<std::uint8_t> filled(int width, int height, std::uint8_t red, std::uint8_t green,
                                 std::uint8_t blue, std::uint8_t alpha) {
    std::vector<std::uint8_t> rgba;
    for (int i = 0; i < width * height; ++i) {
        for (const std::uint8_t value : {red, green, blue, alpha}) rgba.push_back(value);
    }
    return rgba;
}

const std::uint8_t* texel(const GoboPicture& picture, int level, int x, int y) {
    const int size = kGoboSize >> level;
    return &picture.levels[static_cast<std::size_t>(level)][static_cast<std::size_t>(4 * (y * size + x))];
}

TEST(GoboPicture, IsLinearLightTimesAlpha) {
    const auto rgba = filled(3, 2, 188, 255, 0, 128);
    const GoboPicture picture = render::makeGoboPicture(rgba.data(), 3, 2);
    const std::uint8_t* middle = texel(picture, 0, kGoboSize / 2, kGoboSize / 2);
    // IEC 61966-2-1: 188 of 255 is 0.503 of the light.
    EXPECT_EQ(middle[0], std::lround(255.0 * 0.5029 * 128.0 / 255.0));
    EXPECT_EQ(middle[1], 128);
    EXPECT_EQ(middle[2], 0);
    EXPECT_FALSE(picture.grey);
}

TEST(GoboPicture, IsBlackOutsideTheCircle) {
    const GoboPicture picture = whiteGobo();
    EXPECT_EQ(texel(picture, 0, kGoboSize / 2, kGoboSize / 2)[0], 255);
    EXPECT_EQ(texel(picture, 0, 40, 40)[0], 0);
    EXPECT_EQ(texel(picture, 0, 0, kGoboSize / 2)[0], 0);
    EXPECT_EQ(texel(picture, 0, 4, kGoboSize / 2)[0], 255);
}

TEST(GoboPicture, EveryLevelHasTheSameLight) {
    const GoboPicture picture = letterGobo();
    double first = 0.0;
    for (int level = 0; level < kGoboLevels; ++level) {
        const auto& texels = picture.levels[static_cast<std::size_t>(level)];
        const auto count = static_cast<std::size_t>((kGoboSize >> level) * (kGoboSize >> level));
        ASSERT_EQ(texels.size(), 4 * count);
        double mean = 0.0;
        for (std::size_t i = 0; i < count; ++i) mean += texels[4 * i] / (255.0 * static_cast<double>(count));
        if (level == 0) first = mean;
        EXPECT_NEAR(mean, first, 1.0 / 255.0) << "level " << level;
    }
    EXPECT_GT(first, 0.1);
}

TEST(GoboPicture, ALevelsTexelIsTheMeanOfFour) {
    const GoboPicture picture = letterGobo();
    for (int level = 1; level < kGoboLevels; ++level) {
        const int size = kGoboSize >> level;
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const int sum = texel(picture, level - 1, 2 * x, 2 * y)[0] +
                                texel(picture, level - 1, 2 * x + 1, 2 * y)[0] +
                                texel(picture, level - 1, 2 * x, 2 * y + 1)[0] +
                                texel(picture, level - 1, 2 * x + 1, 2 * y + 1)[0];
                // Each is rounded once.
                ASSERT_NEAR(texel(picture, level, x, y)[0], sum / 4.0, 1.0);
            }
        }
    }
}

TEST(GoboPicture, IsGreyWhereItsColoursAreNextToTheSame) {
    EXPECT_TRUE(letterGobo().grey);
    const auto tinted = filled(4, 4, 255, 250, 250, 255);
    EXPECT_FALSE(render::makeGoboPicture(tinted.data(), 4, 4).grey);
}

TEST(GoboPicture, AnEmptyPictureIsRefused) {
    const std::vector<std::uint8_t> rgba(4, 255);
    EXPECT_THROW(render::makeGoboPicture(nullptr, 1, 1), render::RenderError);
    EXPECT_THROW(render::makeGoboPicture(rgba.data(), 0, 1), render::RenderError);
}

}  // namespace
}  // namespace hazer::test
