#include "app/light_color.h"

#include <gtest/gtest.h>

#include "fixtures/color.h"

namespace hazer::app {
namespace {

void expectNear(const render::Color& color, const glm::dvec3& expected, double tolerance) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(color[i], expected[i], tolerance) << "component " << i;
}

TEST(LightColor, d65IsWhite) {
    expectNear(lightColorFromXyz({0.95047, 1.0, 1.08883}), glm::dvec3(1.0), 1e-3);
    expectNear(rec2020FromRec709(glm::dvec3(1.0)), glm::dvec3(1.0), 1e-6);
}

TEST(LightColor, doesNotDependOnBrightness) {
    const glm::dvec3 xyz = fixtures::xyzFromTemperature(3200.0);
    expectNear(lightColorFromXyz(xyz * 0.01), glm::dvec3(lightColorFromXyz(xyz)), 1e-5);
}

TEST(LightColor, hasLuminanceOne) {
    for (const glm::dvec2 chromaticity : {glm::dvec2(0.69, 0.31), {0.17, 0.72}, {0.14, 0.05}, {0.4, 0.4}}) {
        const render::Color color =
            lightColorFromXyz(fixtures::xyzFromCie({chromaticity.x, chromaticity.y, 30.0}));
        EXPECT_NEAR(luminance(glm::dvec3(color)), 1.0, 1e-3);
    }
}

TEST(LightColor, tungstenIsRedderThanDaylight) {
    const render::Color tungsten = lightColorFromXyz(fixtures::xyzFromTemperature(3200.0));
    EXPECT_GT(tungsten.r, 1.2f);
    EXPECT_LT(tungsten.b, 0.6f);
}

TEST(LightColor, movesSpectralColoursOntoTheGamut) {
    // Monochromatic 450 nm lies outside Rec. 2020.
    const render::Color violet = lightColorFromXyz(fixtures::xyzFromCie({0.1566, 0.0177, 10.0}));
    EXPECT_GE(std::min({violet.r, violet.g, violet.b}), -1e-5f);
    EXPECT_GT(violet.b, 5.0f);
}

TEST(LightColor, darknessIsBlack) {
    expectNear(lightColorFromXyz(glm::dvec3(0.0)), glm::dvec3(0.0), 0.0);
}

TEST(LightColor, rec709PrimariesAreInsideRec2020) {
    // ITU-R BT.2087-0: the Rec. 709 red seen in Rec. 2020.
    expectNear(rec2020FromRec709({1.0, 0.0, 0.0}), {0.6274, 0.0691, 0.0164}, 1e-4);
}

}  // namespace
}  // namespace hazer::app
