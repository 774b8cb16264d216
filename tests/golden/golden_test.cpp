// Draws every scene of scenes.json and compares it with the pictures in reference/.
#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>
#include <set>

#include "render/gl/headless_context.h"
#include "tests/golden/scene_list.h"
#include "tests/support/image_compare.h"

namespace hazer::test {

/// How a scene is named in a failure.
void PrintTo(const GoldenScene& scene, std::ostream* stream) {
    *stream << scene.name << ": " << scene.what;
}

namespace {

namespace fs = std::filesystem;

constexpr float kDifferenceGain = 10.0f;

/// One context for all scenes: starting the driver takes longer than drawing.
class Golden : public testing::TestWithParam<GoldenScene> {
 protected:
    static void SetUpTestSuite() { context_ = std::make_unique<render::gl::HeadlessContext>(); }
    static void TearDownTestSuite() { context_.reset(); }

 private:
    static inline std::unique_ptr<render::gl::HeadlessContext> context_;
};

render::ByteImage toBytes(const render::FloatImage& image) {
    render::ByteImage result{image.width, image.height, {}};
    for (const float value : image.rgb)
        result.rgb.push_back(static_cast<std::uint8_t>(std::min(value, 255.0f)));
    return result;
}

/// Leaves what was drawn, what was expected and ten times the difference where a person can look at them.
fs::path keepForInspection(const GoldenScene& scene, const GoldenPictures& actual,
                           const GoldenPictures& expected) {
    const fs::path folder = fs::path(HAZER_GOLDEN_OUTPUT) / scene.name;
    fs::create_directories(folder);
    writeImage(actual.radiance, folder / "actual.exr");
    writeImage(expected.radiance, folder / "expected.exr");
    writeImage(differenceImage(actual.radiance, expected.radiance, kDifferenceGain),
               folder / "difference_x10.exr");
    writeImage(actual.display, folder / "actual.png");
    writeImage(expected.display, folder / "expected.png");
    const render::FloatImage difference =
        differenceImage(toFloat(actual.display), toFloat(expected.display), kDifferenceGain);
    writeImage(toBytes(difference), folder / "difference_x10.png");
    return folder;
}

TEST_P(Golden, LooksAsItDid) {
    const GoldenScene& scene = GetParam();
    const GoldenPictures actual = drawScene(scene);
    const GoldenPictures expected{render::readFloatImage(radianceReference(scene)),
                                  render::readByteImage(displayReference(scene))};
    ASSERT_EQ(actual.radiance.width, expected.radiance.width);
    ASSERT_EQ(actual.radiance.height, expected.radiance.height);
    const Comparison radiance = compareImages(actual.radiance, expected.radiance, scene.radiance);
    EXPECT_TRUE(radiance.within(scene.radiance))
        << "radiance: " << describe(radiance, actual.radiance, expected.radiance);
    const render::FloatImage actualDisplay = toFloat(actual.display);
    const render::FloatImage expectedDisplay = toFloat(expected.display);
    const Comparison display = compareImages(actualDisplay, expectedDisplay, scene.display);
    EXPECT_TRUE(display.within(scene.display))
        << "display: " << describe(display, actualDisplay, expectedDisplay);
    if (HasFailure()) {
        ADD_FAILURE() << "pictures are in " << keepForInspection(scene, actual, expected)
                      << "; if the new one is right: scripts/update_golden " << scene.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Golden, testing::ValuesIn(loadScenes()), [](const auto& instance) {
    std::string name = instance.param.name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST(GoldenReferences, BelongToOneSceneEach) {
    std::set<fs::path> wanted;
    for (const GoldenScene& scene : loadScenes()) {
        EXPECT_TRUE(wanted.insert(radianceReference(scene)).second) << scene.name << " is there twice";
        wanted.insert(displayReference(scene));
    }
    const std::set<fs::path> found{fs::directory_iterator(referenceFolder()), fs::directory_iterator()};
    EXPECT_EQ(found, wanted);
}

}  // namespace
}  // namespace hazer::test
