// Light in the air on a coarse grid: as good as at every pixel, and nothing missed between the nodes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numeric>

#include "render/mesh.h"
#include "tests/support/gl_test.h"

namespace hazer::test {
namespace {

using render::Beam;
using render::Camera;
using render::FloatImage;
using render::Scene;

constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;
// Odd sizes: the last node lies beyond the picture.
constexpr int kWidth = 151;
constexpr int kHeight = 101;

Scene lampInHaze(double fieldDeg, double lensRadiusM) {
    Scene scene;
    Beam beam;
    beam.lensPositionM = {0.0, 0.0, 6.0};
    beam.lensRadiusM = lensRadiusM;
    beam.showsLens = false;
    beam.fieldAngleRad = fieldDeg * kRadPerDeg;
    beam.beamAngleRad = 0.8 * beam.fieldAngleRad;
    beam.fluxLm = 10000.0;
    scene.beams.push_back(beam);
    return scene;
}

/// rms of the difference over rms of the reference.
double relativeError(const FloatImage& image, const FloatImage& reference) {
    double error = 0.0, total = 0.0;
    for (std::size_t i = 0; i < image.rgb.size(); ++i) {
        error += std::pow(image.rgb[i] - reference.rgb[i], 2.0);
        total += std::pow(reference.rgb[i], 2.0);
    }
    EXPECT_GT(total, 0.0);
    return std::sqrt(error / total);
}

double sum(const FloatImage& image) {
    return std::accumulate(image.rgb.begin(), image.rgb.end(), 0.0);
}

class AirGridGl : public GlTest {
 protected:
    FloatImage drawWithStep(const Scene& scene, const Camera& camera, int step) {
        render::Settings settings;
        settings.airStep = step;
        return draw(scene, camera, kWidth, kHeight, settings);
    }

    void expectNothingLost(const Scene& scene, const Camera& camera) {
        const FloatImage reference = drawWithStep(scene, camera, 1);
        for (const int step : {2, 3, 4}) {
            SCOPED_TRACE(step);
            const FloatImage coarse = drawWithStep(scene, camera, step);
            EXPECT_LT(relativeError(coarse, reference), 0.01);
            EXPECT_NEAR(sum(coarse) / sum(reference), 1.0, 0.005);
        }
    }
};

const Camera kSide{{8.0, -5.0, 2.0}, {0.0, 0.0, 3.0}, {0.0, 0.0, 1.0}, 50.0 * kRadPerDeg};

TEST_F(AirGridGl, ABeamFromTheSide) {
    expectNothingLost(lampInHaze(25.0, 0.08), kSide);
}

TEST_F(AirGridGl, BeamsThinnerThanTheGrid) {
    expectNothingLost(lampInHaze(0.4, 0.01), kSide);
    expectNothingLost(lampInHaze(4.0, 0.0), kSide);
}

TEST_F(AirGridGl, FromInsideTheBeam) {
    expectNothingLost(lampInHaze(60.0, 0.08),
                      {{0.2, 0.1, 2.0}, {3.0, 0.0, 2.5}, {0.0, 0.0, 1.0}, 70.0 * kRadPerDeg});
}

// Posts narrower than the grid hide what is behind them all the same, wherever they stand between its nodes.
TEST_F(AirGridGl, BodiesThinnerThanTheGridHideTheBeam) {
    Scene scene = lampInHaze(25.0, 0.08);
    scene.beams.front().castsShadow = false;
    render::MeshInstance post;
    post.mesh = renderer().addMesh(render::makeBox());
    for (const double x : {3.2, 3.53, 3.89, 4.27, 4.7}) {
        post.worldFromMesh = glm::translate(glm::dmat4(1.0), glm::dvec3(x, -2.6, 2.5)) *
                             glm::scale(glm::dmat4(1.0), glm::dvec3(0.04, 0.04, 5.0));
        scene.instances.push_back(post);
    }
    expectNothingLost(scene, kSide);
}

TEST_F(AirGridGl, TwoBeamsThatOverlap) {
    Scene scene = lampInHaze(25.0, 0.08);
    Beam second = scene.beams.front();
    second.lensPositionM.x = -2.0;
    second.worldFromBeam =
        glm::dmat3(glm::rotate(glm::dmat4(1.0), -25.0 * kRadPerDeg, glm::dvec3(0.0, 1.0, 0.0)));
    second.color = {0.2f, 1.3f, 0.4f};
    scene.beams.push_back(second);
    expectNothingLost(scene, kSide);
}

TEST_F(AirGridGl, CountsWhatEachPixelTook) {
    render::Settings settings;
    settings.countsIntegrals = true;
    settings.airStep = 1;
    Scene scene = lampInHaze(25.0, 0.08);
    scene.beams.push_back(scene.beams.front());
    const FloatImage everyPixel = draw(scene, kSide, kWidth, kHeight, settings);
    EXPECT_NEAR(*std::max_element(everyPixel.rgb.begin(), everyPixel.rgb.end()), 2.0f, 1e-4f);
    EXPECT_EQ(everyPixel.at(0, 0)[1], 0.0f);
    settings.airStep = 4;
    const FloatImage onGrid = draw(scene, kSide, kWidth, kHeight, settings);
    EXPECT_NEAR(*std::max_element(onGrid.rgb.begin(), onGrid.rgb.end()), 2.0f, 1e-4f);
    const auto isShared = [](float count) { return std::abs(count - 2.0f / 16.0f) < 1e-4f; };
    EXPECT_GT(std::count_if(onGrid.rgb.begin(), onGrid.rgb.end(), isShared), 100);
    EXPECT_LT(sum(onGrid), sum(everyPixel));
}

}  // namespace
}  // namespace hazer::test
