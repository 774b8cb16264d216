// The haze's swirls in pictures: seeds, wind and turbulence.
#include <algorithm>
#include <cmath>

#include "tests/support/gl_test.h"

namespace hazer::test {
namespace {

constexpr int kSize = 48;

class NoiseMotionGl : public GlTest {
 protected:
    /// The light in the air of a lamp above a camera that looks level; both stand at x [m].
    std::vector<float> drawAt(double timeS, double x = 0.0) {
        render::Beam beam;
        beam.lensPositionM = {x, 0.0, 6.0};
        beam.intensityCd = 1.0e5;
        beam.fieldAngleRad = 0.6;
        beam.beamAngleRad = 0.5;
        beam.showsLens = false;
        scene_.beams = {beam};
        scene_.timeS = timeS;
        render::Settings settings;
        settings.airStep = 1;
        return draw(scene_, {{x, -10.0, 2.0}, {x, 0.0, 2.0}}, kSize, kSize, settings).rgb;
    }

    static double largestDifference(const std::vector<float>& a, const std::vector<float>& b) {
        double largest = 0.0;
        for (std::size_t i = 0; i < a.size(); ++i)
            largest = std::max(largest, static_cast<double>(std::abs(a[i] - b[i])));
        return largest;
    }

    static double brightest(const std::vector<float>& picture) {
        return static_cast<double>(*std::max_element(picture.begin(), picture.end()));
    }

    render::Scene scene_ = [] {
        render::Scene scene;
        scene.haze.noise.amount = 0.8f;
        scene.haze.noise.windMps = {0.5f, 0.0f, 0.0f};
        return scene;
    }();
};

TEST_F(NoiseMotionGl, AnotherSeedAndBackAgain) {
    const std::vector<float> first = drawAt(3.0);
    scene_.haze.noise.seed = 7;
    const std::vector<float> other = drawAt(3.0);
    EXPECT_GT(largestDifference(first, other), 0.05 * brightest(first));
    scene_.haze.noise.seed = 1;
    EXPECT_EQ(largestDifference(first, drawAt(3.0)), 0.0);
}

// Lamp and camera that go with the wind see what they saw.
TEST_F(NoiseMotionGl, WithoutTurbulenceTheSwirlsOnlyDrift) {
    scene_.haze.noise.turbulence = 0.0f;
    const std::vector<float> before = drawAt(3.0, 0.0);
    EXPECT_LT(largestDifference(before, drawAt(7.0, 2.0)), 2e-3 * brightest(before));
    EXPECT_GT(largestDifference(before, drawAt(7.0, 0.0)), 0.05 * brightest(before));
}

TEST_F(NoiseMotionGl, TurbulenceStirsWhatDrifts) {
    const std::vector<float> before = drawAt(3.0, 0.0);
    EXPECT_GT(largestDifference(before, drawAt(7.0, 2.0)), 0.02 * brightest(before));
    // It goes on without jumps.
    EXPECT_LT(largestDifference(before, drawAt(3.001, 0.0005)), 2e-3 * brightest(before));
}

}  // namespace
}  // namespace hazer::test
