// The haze's swirls in pictures: seeds, wind and turbulence, and those too small to be told.
#include <algorithm>
#include <cmath>
#include <utility>

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
        return draw(scene_, {{x, -distanceM_, 2.0}, {x, 0.0, 2.0}}, kSize, kSize, settings).rgb;
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

    /// Light over that of even haze, green alone, of pixels where there is some; 0 elsewhere.
    std::vector<double> densities(double timeS) {
        const std::vector<float> uneven = drawAt(timeS);
        const float amount = std::exchange(scene_.haze.noise.amount, 0.0f);
        const std::vector<float> even = drawAt(timeS);
        scene_.haze.noise.amount = amount;
        const double darkest = 0.02 * brightest(even);
        std::vector<double> ratios;
        for (std::size_t i = 1; i < even.size(); i += 3) {
            const bool isLit = static_cast<double>(even[i]) > darkest;
            ratios.push_back(isLit ? static_cast<double>(uneven[i]) / static_cast<double>(even[i]) : 0.0);
        }
        return ratios;
    }

    double distanceM_ = 10.0;
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

// A day later and 43 km away nothing has lost its digits.
TEST_F(NoiseMotionGl, ADayLaterTheyAreAsSharp) {
    constexpr double kLaterS = 86400.0;
    scene_.haze.noise.turbulence = 0.0f;
    const std::vector<float> before = drawAt(3.0, 0.0);
    EXPECT_LT(largestDifference(before, drawAt(3.0 + kLaterS, 0.5 * kLaterS)), 2e-3 * brightest(before));
}

// Swirls of a few centimetres from 40 m: a pixel holds hundreds of them.
TEST_F(NoiseMotionGl, SwirlsFarSmallerThanAPixelAreEvenHaze) {
    distanceM_ = 40.0;
    scene_.haze.noise.amount = 1.0f;
    scene_.haze.noise.scaleM = 0.05f;
    for (const double ratio : densities(3.0)) {
        if (ratio > 0.0) {
            EXPECT_NEAR(ratio, 1.0, 1e-3);
        }
    }
}

// What is moved by less than a pixel changes a pixel by little, however small the swirls.
TEST_F(NoiseMotionGl, SmallSwirlsDoNotFlicker) {
    scene_.haze.noise.amount = 1.0f;
    scene_.haze.noise.windMps = {0.5f, 0.2f, 0.1f};
    for (const float scaleM : {1.0f, 0.3f, 0.1f, 0.03f}) {
        scene_.haze.noise.scaleM = scaleM;
        const std::vector<double> before = densities(3.0);
        const std::vector<double> after = densities(3.02);
        double largest = 0.0;
        for (std::size_t i = 0; i < before.size(); ++i) {
            if (before[i] > 0.0) largest = std::max(largest, std::abs(after[i] - before[i]));
        }
        EXPECT_LT(largest, 0.05) << scaleM;
    }
}

}  // namespace
}  // namespace hazer::test
