// Views of a picture: error and cost in numbers and colours.
#include "app/picture_view.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hazer::test {
namespace {

render::FloatImage grey(const std::vector<float>& values) {
    render::FloatImage image{static_cast<int>(values.size()), 1, {}};
    for (const float value : values) image.rgb.insert(image.rgb.end(), 3, value);
    return image;
}

TEST(PictureView, AnErrorIsAShareOfTheLightThere) {
    const render::FloatImage view = app::errorView(grey({110.0f, 9.0f, 5.0f}), grey({100.0f, 10.0f, 5.0f}));
    EXPECT_NEAR(view.at(0, 0)[0], 0.1, 1e-6);
    EXPECT_NEAR(view.at(1, 0)[1], 0.1, 1e-6);
    EXPECT_EQ(view.at(2, 0)[2], 0.0f);
}

// rms of {100, 0} is 100 / sqrt(2) a channel: in the dark a hundredth of it stands in for the light.
TEST(PictureView, InTheDarkItIsAShareOfAHundredthOfThePicture) {
    const render::FloatImage view = app::errorView(grey({100.0f, 0.1f}), grey({100.0f, 0.0f}));
    EXPECT_NEAR(view.at(1, 0)[0], 0.1 / (100.0 / std::sqrt(2.0) * 0.01), 1e-4);
}

TEST(PictureView, ADarkPictureHasNoError) {
    EXPECT_EQ(app::errorView(grey({0.0f}), grey({0.0f})).at(0, 0)[0], 0.0f);
}

TEST(PictureView, ColoursGrowLighterWithTheNumber) {
    const render::ByteImage image =
        app::falseColor(grey({0.0f, 1.1e-4f, 1e-3f, 1e-2f, 1e-1f, 9.0f}), 1e-4, 1e-1);
    const auto lightness = [&](std::size_t pixel) {
        return 2 * image.rgb[3 * pixel] + 7 * image.rgb[3 * pixel + 1] + image.rgb[3 * pixel + 2];
    };
    EXPECT_EQ(lightness(0), 0);
    for (std::size_t pixel = 1; pixel < 5; ++pixel) EXPECT_GT(lightness(pixel), lightness(pixel - 1));
    EXPECT_EQ(lightness(5), lightness(4));
}

TEST(PictureView, SaysWhatItHolds) {
    EXPECT_EQ(app::viewSummary(grey({0.0f, 0.0f})), "0 everywhere");
    EXPECT_EQ(app::viewSummary(grey({0.0f, 0.5f})), "mean 2.50e-01, 99 % within 5.00e-01, largest 5.00e-01");
}

}  // namespace
}  // namespace hazer::test
