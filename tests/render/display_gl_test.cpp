// From radiance to the display: colours, dither, what is interpolated between blocks, edges.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/support/exact_display.h"
#include "tests/support/gl_test.h"

namespace hazer::test {
namespace {

constexpr double kStep = 1.0 / 255.0;

struct Pictures {
    render::FloatImage radiance;
    render::ByteImage display;
};

glm::dvec3 shownAt(const render::ByteImage& image, int x, int y) {
    const std::size_t at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                static_cast<std::size_t>(x));
    return glm::dvec3(image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]) * kStep;
}

class DisplayGl : public GlTest {
 protected:
    Pictures drawBoth(const render::Scene& scene, const render::Camera& camera, int width, int height) {
        settings_.width = width;
        settings_.height = height;
        renderer().render(scene, camera, settings_);
        return {renderer().readRadiance(), renderer().readDisplay()};
    }

    /// A picture of one colour; in sensor full scales, Rec. 2020. The mean takes the dither out.
    glm::dvec3 meanOfPlain(const glm::dvec3& light) {
        constexpr int kSize = 64;
        render::Scene scene;
        scene.backgroundCdPerM2 = light / sensorScale(static_cast<double>(settings_.exposureEv100));
        const Pictures pictures = drawBoth(scene, {}, kSize, kSize);
        glm::dvec3 sum(0.0);
        for (int y = 0; y < kSize; ++y) {
            for (int x = 0; x < kSize; ++x) sum += shownAt(pictures.display, x, y);
        }
        return sum / static_cast<double>(kSize * kSize);
    }

    glm::dvec3 exactAt(const render::FloatImage& radiance, int x, int y) const {
        const float* c = radiance.at(x, y);
        return exactDisplay(rec2020FromRec709(glm::dvec3(c[0], c[1], c[2])) *
                            sensorScale(static_cast<double>(settings_.exposureEv100)));
    }

    render::MeshId add(const render::Mesh& mesh) { return renderer().addMesh(mesh); }

    render::Settings settings_ = [] {
        render::Settings settings;
        settings.bloom = false;
        return settings;
    }();
};

double largest(const glm::dvec3& v) {
    return std::max({v.r, v.g, v.b});
}

TEST_F(DisplayGl, ColoursAreAgx) {
    for (double stops = -12.0; stops <= 4.5; stops += 0.37) {
        for (const glm::dvec3& tint : {glm::dvec3(1.0), glm::dvec3(1.0, 0.3, 0.05),
                                       glm::dvec3(0.02, 0.1, 1.0), glm::dvec3(0.0, 1.0, 0.0)}) {
            const glm::dvec3 light = tint * std::exp2(stops);
            EXPECT_LT(largest(glm::abs(meanOfPlain(light) - exactDisplay(light))), kStep)
                << stops << " stops, tint " << tint.r << " " << tint.g << " " << tint.b;
        }
    }
}

TEST_F(DisplayGl, BlackIsBlack) {
    const Pictures pictures = drawBoth({}, {}, 64, 64);
    EXPECT_EQ(*std::max_element(pictures.display.rgb.begin(), pictures.display.rgb.end()), 0);
}

// Less than half a step of error over a range of a few steps: rounding alone would make flat bands.
TEST_F(DisplayGl, DitherShowsWhatLiesBetweenTheSteps) {
    double before = 0.0;
    for (double stops = -9.0; stops < -7.0; stops += 0.05) {
        const glm::dvec3 light(std::exp2(stops));
        const double mean = meanOfPlain(light).g;
        EXPECT_NEAR(mean, exactDisplay(light).g, 0.35 * kStep) << stops;
        EXPECT_GT(mean, before);
        before = mean;
    }
}

// Flat noise of one step either way: 8 bits take on three or four values, in the shares of a triangle.
TEST_F(DisplayGl, DitherIsATriangleOfOneStep) {
    constexpr int kSize = 256;
    render::Scene scene;
    scene.backgroundCdPerM2 = render::Color(0.03f / static_cast<float>(sensorScale(8.0)));
    const Pictures pictures = drawBoth(scene, {}, kSize, kSize);
    const double exact = exactAt(pictures.radiance, 0, 0).g / kStep;
    double sum = 0.0, squares = 0.0;
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const double off = shownAt(pictures.display, x, y).g / kStep - exact;
            EXPECT_LE(std::abs(off), 2.0);
            sum += off;
            squares += off * off;
        }
    }
    constexpr double kCount = kSize * kSize;
    EXPECT_NEAR(sum / kCount, 0.0, 0.3);
    // Triangle of +-1: 1/6; rounding: 1/12.
    EXPECT_NEAR(squares / kCount, 1.0 / 6.0 + 1.0 / 12.0, 0.05);
}

/// The light of a wide lamp in haze with swirls of many metres: slow gradients, dark enough for a step to be
/// seen.
render::Scene slowSwirls() {
    render::Scene scene;
    render::Beam beam;
    beam.lensPositionM = {-12.0, 0.0, 2.0};
    beam.worldFromBeam =
        glm::dmat3(glm::dvec3(0.0, -1.0, 0.0), glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(-1.0, 0.0, 0.0));
    beam.fieldAngleRad = 2.6;
    beam.edge = render::BeamEdge::kFlat;
    beam.intensityCd = 4000.0;
    beam.showsLens = false;
    scene.beams.push_back(beam);
    scene.haze.extinctionPerM = scene.haze.scatteringPerM = 0.02f;
    scene.haze.phase = {0.0f, 0.0f, 1.0f};
    scene.haze.noise.amount = 1.0f;
    scene.haze.noise.scaleM = 8.0f;
    return scene;
}

// A volume of bytes would be stairs here, with bends of 2 %. What is left are the creases of linear
// interpolation.
TEST_F(DisplayGl, ASlowGradientInUnevenHazeHasNoSteps) {
    constexpr int kWidth = 512;
    constexpr int kHeight = 64;
    settings_.exposureEv100 = 3.0f;
    const Pictures pictures =
        drawBoth(slowSwirls(), {{0.0, -10.0, 2.0}, {0.0, 0.0, 2.0}, {0.0, 0.0, 1.0}, 0.1}, kWidth, kHeight);
    double largestBend = 0.0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 1; x + 1 < kWidth; ++x) {
            const auto at = [&](int column) {
                return static_cast<double>(pictures.radiance.at(column, y)[1]);
            };
            largestBend = std::max(largestBend, std::abs(at(x + 1) - 2.0 * at(x) + at(x - 1)) / at(x));
        }
    }
    EXPECT_LT(largestBend, 6e-3);
}

// Dither breaks up what 8 bits round to bands: no value stands for long, and blocks of pixels have the mean
// of what was drawn.
TEST_F(DisplayGl, ASlowGradientInUnevenHazeHasNoBands) {
    constexpr int kWidth = 512;
    constexpr int kHeight = 64;
    settings_.exposureEv100 = 3.0f;
    const Pictures pictures =
        drawBoth(slowSwirls(), {{0.0, -10.0, 2.0}, {0.0, 0.0, 2.0}, {0.0, 0.0, 1.0}, 0.1}, kWidth, kHeight);
    int longestRun = 0, longestUndithered = 0;
    double largestError = 0.0;
    for (int y = 0; y < kHeight; ++y) {
        int run = 0, undithered = 0;
        for (int x = 1; x < kWidth; ++x) {
            const auto rounded = [&](int column) {
                return std::lround(exactAt(pictures.radiance, column, y).g / kStep);
            };
            run = shownAt(pictures.display, x, y).g == shownAt(pictures.display, x - 1, y).g ? run + 1 : 0;
            undithered = rounded(x) == rounded(x - 1) ? undithered + 1 : 0;
            longestRun = std::max(longestRun, run);
            longestUndithered = std::max(longestUndithered, undithered);
        }
    }
    constexpr int kBlock = 16;
    for (int y = 0; y < kHeight; y += kBlock) {
        for (int x = 0; x < kWidth; x += kBlock) {
            double sum = 0.0;
            for (int i = 0; i < kBlock * kBlock; ++i) {
                const int column = x + i % kBlock, row = y + i / kBlock;
                sum += shownAt(pictures.display, column, row).g - exactAt(pictures.radiance, column, row).g;
            }
            largestError = std::max(largestError, std::abs(sum) / (kBlock * kBlock));
        }
    }
    EXPECT_GT(longestUndithered, 20);
    EXPECT_LT(longestRun, 14);
    EXPECT_LT(largestError, 0.2 * kStep);
}

/// A ball and a slanted board in ambient light, and a beam through haze: smooth and not, dark and bright.
class DisplayOfAStage : public DisplayGl {
 protected:
    render::Scene stage() {
        render::Scene scene;
        scene.ambient.illuminanceLx = 300.0f;
        render::Beam beam;
        beam.lensPositionM = {-3.0, 2.0, 5.0};
        beam.worldFromBeam =
            glm::dmat3(glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(-0.8, 0.0, -0.6), glm::dvec3(-0.6, 0.0, 0.8));
        beam.intensityCd = 2.0e5;
        beam.showsLens = false;
        scene.beams.push_back(beam);
        scene.haze.extinctionPerM = scene.haze.scatteringPerM = 0.02f;
        scene.instances.push_back({add(render::makeSphere()),
                                   glm::dmat4(glm::dmat3(2.0)),
                                   {{0.6f, 0.3f, 0.1f}, 0.05f, 60.0f},
                                   true});
        scene.instances.back().worldFromMesh[3] = {0.5, 1.0, 1.2, 1.0};
        scene.instances.push_back({add(render::makePlane()), glm::dmat4(glm::dmat3(8.0)), {}, true});
        return scene;
    }
    static constexpr int kWidth = 322;
    static constexpr int kHeight = 181;
};

/// Steps of luma between a pixel and its diagonal neighbours, on which the antialias pass may act.
bool mayBeSmoothed(const std::function<glm::dvec3(int, int)>& exact, int x, int y, int width, int height) {
    double darkest = 1.0, brightest = 0.0;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            const double luma =
                glm::dot(exact(std::clamp(x + dx, 0, width - 1), std::clamp(y + dy, 0, height - 1)),
                         glm::dvec3(0.299, 0.587, 0.114));
            darkest = std::min(darkest, luma);
            brightest = std::max(brightest, luma);
        }
    }
    return brightest - darkest > 0.02;
}

TEST_F(DisplayOfAStage, InterpolatesOnlyWhatIsSmooth) {
    const Pictures pictures = drawBoth(stage(), {}, kWidth, kHeight);
    const auto exact = [&](int x, int y) { return exactAt(pictures.radiance, x, y); };
    double squares = 0.0;
    int count = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            if (mayBeSmoothed(exact, x, y, kWidth, kHeight)) continue;
            const double off = largest(glm::abs(shownAt(pictures.display, x, y) - exact(x, y))) / kStep;
            // Two steps by interpolation, one by the dither, half by rounding.
            EXPECT_LE(off, 4.0) << x << " " << y;
            squares += off * off;
            ++count;
        }
    }
    EXPECT_GT(count, kWidth * kHeight / 2);
    EXPECT_LT(std::sqrt(squares / count), 0.9);
}

/// A bright half plane above a dark one, the border rising by one pixel every few.
render::Scene slantedEdge(render::MeshId plane, double slope) {
    render::Scene scene;
    scene.ambient.illuminanceLx = 3.0f;
    glm::dmat4 board(glm::dvec4(8.0, 8.0 * slope, 0.0, 0.0), glm::dvec4(-8.0 * slope, 8.0, 0.0, 0.0),
                     glm::dvec4(0.0, 0.0, 1.0, 0.0), glm::dvec4(0.0, 4.0, -10.0, 1.0));
    scene.instances.push_back({plane, board, {}, true});
    return scene;
}

// Wherever the edge lies relative to the blocks, each of its steps is softened.
TEST_F(DisplayGl, EveryStepOfAnEdgeIsSmoothed) {
    constexpr int kSize = 128;
    settings_.exposureEv100 = 1.0f;
    const render::Camera camera{{0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, 0.5};
    const Pictures pictures = drawBoth(slantedEdge(add(render::makePlane()), 0.09), camera, kSize, kSize);
    const auto topOfDark = [&](int x) {
        int y = 0;
        while (y < kSize && pictures.radiance.at(x, y)[1] > 0.0f) ++y;
        return y;
    };
    int steps = 0;
    for (int x = 4; x + 5 < kSize; ++x) {
        const int row = topOfDark(x);
        if (row < 3 || row + 3 > kSize || topOfDark(x + 1) == row) continue;
        ++steps;
        double change = 0.0;
        for (int dx = 0; dx <= 1; ++dx) {
            for (int dy = -1; dy <= 1; ++dy)
                change = std::max(change, largest(glm::abs(shownAt(pictures.display, x + dx, row + dy) -
                                                           exactAt(pictures.radiance, x + dx, row + dy))));
        }
        EXPECT_GT(change, 0.05) << "at " << x << ", " << row;
    }
    EXPECT_GE(steps, 8);
}

}  // namespace
}  // namespace hazer::test
