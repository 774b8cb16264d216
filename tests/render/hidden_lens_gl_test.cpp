// A lamp whose lens is not drawn lights the air all the same.
#include <algorithm>
#include <cmath>

#include "render/scene_plan.h"
#include "tests/support/gl_test.h"

namespace hazer::test {
namespace {

/// A lamp with a large lens that looks into the camera, in clear air: the lens is all there is to see.
render::Scene lampIntoTheCamera() {
    render::Scene scene;
    render::Beam beam;
    beam.lensPositionM = {0.0, 0.0, 4.0};
    beam.lensRadiusM = 0.5;
    beam.intensityCd = 1000.0;
    scene.beams.push_back(beam);
    scene.haze.scatteringPerM = 0.0f;
    return scene;
}

constexpr int kSize = 16;
const render::Camera kBelow{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}, 0.8};

float brightest(const render::FloatImage& image) {
    return *std::max_element(image.rgb.begin(), image.rgb.end());
}

class HiddenLensGl : public GlTest {};

TEST_F(HiddenLensGl, IsNeitherPlannedNorDrawn) {
    render::Scene scene = lampIntoTheCamera();
    EXPECT_FALSE(render::planScene(scene, kBelow, {}, {}).lenses.empty());
    EXPECT_GT(brightest(draw(scene, kBelow, kSize, kSize)), 100.0f);
    scene.beams.front().showsLens = false;
    EXPECT_TRUE(render::planScene(scene, kBelow, {}, {}).lenses.empty());
    EXPECT_EQ(brightest(draw(scene, kBelow, kSize, kSize)), 0.0f);
}

TEST_F(HiddenLensGl, StaysHiddenBesideOneThatShows) {
    render::Scene scene = lampIntoTheCamera();
    render::Beam elsewhere = scene.beams.front();
    elsewhere.lensPositionM = {50.0, 0.0, 4.0};
    scene.beams.push_back(elsewhere);
    scene.beams.front().showsLens = false;
    EXPECT_FALSE(render::planScene(scene, kBelow, {}, {}).lenses.empty());
    EXPECT_EQ(brightest(draw(scene, kBelow, kSize, kSize)), 0.0f);
}

TEST_F(HiddenLensGl, StillLightsTheAir) {
    render::Scene scene = lampIntoTheCamera();
    scene.haze.scatteringPerM = 0.01f;
    scene.beams.front().showsLens = false;
    EXPECT_GT(brightest(draw(scene, kBelow, kSize, kSize)), 0.0f);
}

}  // namespace
}  // namespace hazer::test
