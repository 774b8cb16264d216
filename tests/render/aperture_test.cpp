// Edges in a beam's way, as the shaders have them: how much light passes in all is the area that is left
// open.
#include <gtest/gtest.h>

#include <cmath>

#include "render/glsl_as_cpp.h"

namespace hazer::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// The integral over a square of half the size `reach`.
template <typename Through>
double area(Through through, double reach = 2.0) {
    constexpr int kSteps = 1200;
    const double step = 2.0 * reach / kSteps;
    double sum = 0.0;
    for (int y = 0; y < kSteps; ++y) {
        for (int x = 0; x < kSteps; ++x)
            sum += through(glm::dvec2((x + 0.5) * step - reach, (y + 0.5) * step - reach));
    }
    return sum * step * step;
}

class Aperture : public ::testing::Test {
 protected:
    render::glsl::Formulas<double> formulas_;
};

// A ramp takes as much inside of its edge as it gives outside.
TEST_F(Aperture, SoftEdgesKeepTheArea) {
    for (const double width : {0.01, 0.3}) {
        EXPECT_NEAR(area([&](const glm::dvec2& p) {
                        return formulas_.throughRectangle(p, {0.8, 0.4}, width);
                    }),
                    4.0 * 0.8 * 0.4, 1e-3);
        EXPECT_NEAR(
            area([&](const glm::dvec2& p) {
                return formulas_.throughBlade(p, {0.6, 0.8, 0.25}, width);
            }),
            16.0 - area([&](const glm::dvec2& p) { return 0.6 * p.x + 0.8 * p.y > 0.25 ? 1.0 : 0.0; }), 2e-2);
        // Around a disc the ring outside of the edge is the larger one.
        EXPECT_NEAR(area([&](const glm::dvec2& p) { return formulas_.throughIris(p, 0.7, width); }),
                    kPi * (0.49 + width * width / 12.0), 1e-3);
    }
}

// Both sides of a slit that is narrower than its edges are soft shade it.
TEST_F(Aperture, ANarrowSlitIsDim) {
    EXPECT_NEAR(formulas_.throughSlit(0.0, 0.05, 0.4), 0.25, 1e-12);
    EXPECT_EQ(formulas_.throughRectangle({0.3, 0.0}, {0.05, 1.0}, 0.4), 0.0);
    EXPECT_EQ(formulas_.throughIris({0.0, 0.0}, 0.5, 0.0), 1.0);
    EXPECT_EQ(formulas_.throughIris({0.6, 0.0}, 0.5, 0.0), 0.0);
    // The same for a hole, and one that is shut has no middle.
    EXPECT_NEAR(formulas_.throughIris({0.0, 0.0}, 0.05, 0.4), 0.25, 1e-12);
    EXPECT_EQ(formulas_.throughIris({0.0, 0.0}, 0.0, 0.4), 0.0);
    EXPECT_EQ(formulas_.throughIris({0.1, 0.0}, 0.0, 0.4), 0.0);
}

// A picture that is turned counter-clockwise shows what was to the right above.
TEST_F(Aperture, PicturesTurnAndMove) {
    const glm::dvec2 quarterTurn(0.0, 1.0);
    const glm::dvec2 place = formulas_.onApertureImage({0.0, 1.0}, quarterTurn, {0.0, 0.0, 1.0});
    EXPECT_NEAR(place.x, 1.0, 1e-12);
    EXPECT_NEAR(place.y, 0.0, 1e-12);
    const glm::dvec2 shifted = formulas_.onApertureImage({0.5, 0.0}, {1.0, 0.0}, {-0.5, 1.0, 2.0});
    EXPECT_NEAR(shifted.x, 0.5, 1e-12);
    EXPECT_NEAR(shifted.y, -0.5, 1e-12);
}

}  // namespace
}  // namespace hazer::test
