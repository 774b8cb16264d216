// Composed apertures: what is in the picture, texel by texel, and that beams shine through it as through a
// gobo of the same.
#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "tests/support/gl_test.h"

namespace hazer::test {
namespace {

using render::Aperture;
using render::ApertureShape;
using render::Beam;
using render::Camera;
using render::FloatImage;
using render::Scene;

constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;
constexpr int kTexels = 512;
constexpr int kSize = 160;

/// Light that a place of the beam's cross-section lets through.
using Through = std::function<glm::dvec3(const glm::dvec2&)>;

std::uint8_t srgbByte(double linear) {
    const double c = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(c, 0.0, 1.0)));
}

/// A picture of what lets light through, each texel the mean of 16 places.
std::vector<std::uint8_t> pictureOf(const Through& through) {
    std::vector<std::uint8_t> rgba;
    for (int y = 0; y < kTexels; ++y) {
        for (int x = 0; x < kTexels; ++x) {
            glm::dvec3 sum(0.0);
            for (int i = 0; i < 16; ++i) {
                const glm::dvec2 at(x + (i % 4 + 0.5) / 4.0, y + (i / 4 + 0.5) / 4.0);
                sum += through({2.0 * at.x / kTexels - 1.0, 1.0 - 2.0 * at.y / kTexels});
            }
            for (int c = 0; c < 3; ++c) rgba.push_back(srgbByte(sum[c] / 16.0));
            rgba.push_back(255);
        }
    }
    return rgba;
}

glm::dvec3 grey(bool isOpen) {
    return glm::dvec3(isOpen ? 1.0 : 0.0);
}

/// Open where right of the middle and above it.
glm::dvec3 quarter(const glm::dvec2& place) {
    return grey(place.x > 0.0 && place.y > 0.0 && glm::length(place) < 1.0);
}

glm::dvec2 turned(const glm::dvec2& v, double rad) {
    return {std::cos(rad) * v.x - std::sin(rad) * v.y, std::sin(rad) * v.x + std::cos(rad) * v.y};
}

class ApertureGl : public GlTest {
 protected:
    void SetUp() override {
        GlTest::SetUp();
        if (IsSkipped()) return;
        plane_ = renderer().addMesh(render::makePlane());
        gobo_ = add(quarter);
    }

    render::GoboId add(const Through& through) {
        return renderer().addGobo(pictureOf(through).data(), kTexels, kTexels);
    }

    /// A lamp at 6 m over a floor, seen from the side.
    Scene lamp() const {
        Scene scene;
        Beam beam;
        beam.lensPositionM = {0.0, 0.0, 6.0};
        beam.lensRadiusM = 0.02;
        beam.fieldAngleRad = 30.0 * kRadPerDeg;
        beam.beamAngleRad = 22.0 * kRadPerDeg;
        beam.fluxLm = 10000.0;
        beam.showsLens = false;
        scene.beams.push_back(beam);
        render::MeshInstance floor;
        floor.mesh = plane_;
        floor.worldFromMesh = glm::scale(glm::dmat4(1.0), glm::dvec3(40.0, 40.0, 1.0));
        floor.castsShadow = false;
        scene.instances.push_back(floor);
        return scene;
    }

    /// A given number of samples takes gobos and apertures the same way; otherwise gobos have tables.
    FloatImage drawn(const Scene& scene, int samples = 96) {
        render::Settings settings;
        settings.samples = samples;
        settings.maxError = 0.01;
        const Camera camera{{1.0, -8.0, 4.0}, {0.0, 0.0, 2.5}, {0.0, 0.0, 1.0}, 45.0 * kRadPerDeg};
        return draw(scene, camera, kSize, kSize, settings);
    }

    /// Difference of two pictures, a share of the second.
    static double difference(const FloatImage& a, const FloatImage& b) {
        double error = 0.0, light = 0.0;
        for (std::size_t i = 0; i < b.rgb.size(); ++i) {
            error += std::pow(a.rgb[i] - b.rgb[i], 2.0);
            light += std::pow(b.rgb[i], 2.0);
        }
        return std::sqrt(error / light);
    }

    /// The same light through an aperture and through a gobo that shows what the aperture should be.
    void expectSame(const Aperture& aperture, const Through& through, const char* what, bool hasGobo = false,
                    double tolerance = 0.015) {
        Scene scene = lamp();
        Beam& beam = scene.beams.front();
        beam.aperture = aperture;
        if (hasGobo) {
            beam.gobo = gobo_;
            beam.goboRotationRad = 0.5;
        }
        const FloatImage got = drawn(scene);
        // Pictures that are turned are looked at through mip levels whose squares are turned: both had better
        // be, or neither, and even so a share of the light along edges differs.
        const double left = hasGobo && !isRound(aperture) ? 0.5 : 0.0;
        beam.goboRotationRad -= left;
        beam.aperture = {};
        beam.gobo = add([&](const glm::dvec2& place) {
            return through(place) * (hasGobo ? quarter(turned(place, -left)) : glm::dvec3(1.0));
        });
        const FloatImage want = drawn(scene);
        EXPECT_LT(difference(got, want), tolerance) << what;
        beam.gobo = -1;
        EXPECT_GT(difference(drawn(scene), want), 0.1) << what << " does nothing";
    }

    render::MeshId plane_ = -1;
    render::GoboId gobo_ = -1;
};

TEST_F(ApertureGl, BladesCutFromTheirSide) {
    Aperture aperture;
    aperture.blades[0] = {turned({0.0, -1.0}, 0.3), 0.2};
    aperture.blades[2] = {{0.0, 1.0}, 0.5};
    const auto through = [](const glm::dvec2& place) {
        return grey(glm::dot(turned({0.0, -1.0}, 0.3), place) < 0.2 && place.y < 0.5);
    };
    expectSame(aperture, through, "blades");
    expectSame(aperture, through, "blades over a gobo", true);
}

TEST_F(ApertureGl, AnIrisClosesOverAGobo) {
    Aperture aperture;
    aperture.irisRadius = 0.6;
    expectSame(
        aperture, [](const glm::dvec2& place) { return grey(glm::length(place) < 0.6); }, "iris", true);
}

TEST_F(ApertureGl, RectanglesAndOvals) {
    Aperture aperture;
    aperture.shape = ApertureShape::kRectangle;
    aperture.halfSize = {0.8, 0.3};
    expectSame(
        aperture,
        [](const glm::dvec2& place) { return grey(std::abs(place.x) < 0.8 && std::abs(place.y) < 0.3); },
        "rectangle");
    aperture.shape = ApertureShape::kOval;
    expectSame(
        aperture,
        [](const glm::dvec2& place) { return grey(glm::length(place / glm::dvec2(0.8, 0.3)) < 1.0); },
        "oval");
}

TEST_F(ApertureGl, SoftEdgesAreRamps) {
    Aperture aperture;
    aperture.blades[1] = {{1.0, 0.0}, 0.1};
    aperture.softness = 0.6;
    expectSame(
        aperture,
        [](const glm::dvec2& place) { return glm::dvec3(std::clamp(0.5 + (0.1 - place.x) / 0.6, 0.0, 1.0)); },
        "barn door");
}

TEST_F(ApertureGl, TwoColorsAtOnce) {
    Aperture aperture;
    aperture.split = {{0.0, 1.0}, -0.2};
    aperture.color = {1.0f, 0.2f, 0.1f};
    aperture.beyondColor = {0.1f, 0.3f, 0.9f};
    expectSame(
        aperture,
        [](const glm::dvec2& place) {
            return place.y < -0.2 ? glm::dvec3(1.0, 0.2, 0.1) : glm::dvec3(0.1, 0.3, 0.9);
        },
        "split colour");
}

// A second wheel that turns the other way, shifted by a shake, and a disc larger than the beam.
TEST_F(ApertureGl, FurtherWheelsLieOverTheFirst) {
    Aperture aperture;
    aperture.images[0] = {gobo_, -0.7, {0.1, -0.2}, 1.0};
    const auto second = [](const glm::dvec2& place) {
        return quarter(turned(place - glm::dvec2(0.1, -0.2), 0.7));
    };
    expectSame(aperture, second, "second wheel");
    expectSame(aperture, second, "both wheels", true);
    aperture.images[0] = {gobo_, 0.3, {-1.5, 0.3}, 3.0};
    expectSame(
        aperture,
        [](const glm::dvec2& place) { return quarter(turned((place - glm::dvec2(-1.5, 0.3)) / 3.0, -0.3)); },
        "animation disc");
}

// One shader for each number of pictures.
TEST_F(ApertureGl, AsManyPicturesAsThereMayBe) {
    Aperture aperture;
    const auto turn = [](std::size_t i) { return 0.2 * static_cast<double>(i); };
    for (std::size_t i = 0; i < aperture.images.size(); ++i) {
        aperture.images[i] = {gobo_, turn(i + 1), {0.0, 0.0}, 1.0};
        const auto through = [&](const glm::dvec2& place) {
            glm::dvec3 light(1.0);
            for (std::size_t k = 0; k <= i; ++k) light *= quarter(turned(place, -turn(k + 1)));
            return light;
        };
        expectSame(aperture, through, "pictures", i % 2 == 1);
    }
}

// As through a cylindrical lens that stretches along a slanted axis, and mirrors.
TEST_F(ApertureGl, AStretchIsOfAllThatIsInTheWay) {
    const glm::dmat2 axes(turned({1.0, 0.0}, 0.4), turned({0.0, 1.0}, 0.4));
    Aperture aperture;
    aperture.stretch = axes * glm::dmat2(1.0, 0.0, 0.0, -0.4) * glm::transpose(axes);
    const glm::dmat2 back = glm::inverse(aperture.stretch);
    // Edges are a texel wide along the shortest axis, which is more along the longest.
    constexpr double kWiderEdges = 0.03;
    expectSame(
        aperture, [&](const glm::dvec2& place) { return grey(glm::length(back * place) < 1.0); }, "field",
        false, kWiderEdges);
    aperture.images[0] = {gobo_, 0.3, {0.1, 0.0}, 1.0};
    aperture.blades[0] = {turned({0.0, -1.0}, 0.3), 0.2};
    expectSame(
        aperture,
        [&](const glm::dvec2& place) {
            const glm::dvec2 at = back * place;
            const bool isOpen = glm::dot(turned({0.0, -1.0}, 0.3), at) < 0.2 && glm::length(at) < 1.0;
            return quarter(turned(at - glm::dvec2(0.1, 0.0), -0.3)) * grey(isOpen);
        },
        "gobo and blade", false, kWiderEdges);
}

// Pictures are kept from frame to frame, and drawn anew where an aperture changes or a gobo comes.
TEST_F(ApertureGl, ChangesAreSeen) {
    Scene scene = lamp();
    scene.beams.push_back(scene.beams.front());
    scene.beams[1].lensPositionM.x = 3.0;
    scene.beams[0].aperture.blades[0].distance = 0.0;
    scene.beams[1].aperture.blades[0].distance = 0.5;
    const FloatImage before = drawn(scene);
    Scene changed = scene;
    changed.beams[0].aperture.blades[0] = {{0.0, 1.0}, 0.3};
    const FloatImage after = drawn(changed);
    EXPECT_GT(difference(after, before), 0.05);
    EXPECT_EQ(drawn(scene).rgb, before.rgb);
    add(quarter);
    EXPECT_EQ(drawn(scene).rgb, before.rgb);
    std::swap(scene.beams[0].aperture, scene.beams[1].aperture);
    std::swap(scene.beams[0].lensPositionM, scene.beams[1].lensPositionM);
    EXPECT_LT(difference(drawn(scene), before), 1e-6);
}

// What is composed has no table: it is looked at in cells along the ray, which keeps the error that is asked
// for.
TEST_F(ApertureGl, InTheAirItKeepsTheErrorAskedFor) {
    Scene scene = lamp();
    scene.instances.clear();
    scene.beams[0].gobo = gobo_;
    scene.beams[0].aperture.irisRadius = 0.6;
    scene.beams[0].aperture.blades[0].distance = 0.3;
    EXPECT_LT(difference(drawn(scene, 0), drawn(scene, 1024)), 0.01);
}

// Frost blurs a gobo's edges, and takes no light away.
TEST_F(ApertureGl, FrostBlursAGobo) {
    Scene scene = lamp();
    scene.haze.scatteringPerM = 0.0f;
    scene.haze.extinctionPerM = 0.0f;
    scene.beams[0].edge = render::BeamEdge::kFlat;
    scene.beams[0].gobo = gobo_;
    const auto measure = [&](double frostDeg, double& flux, double& steepest) {
        scene.beams[0].frostRad = frostDeg * kRadPerDeg;
        // All within the field.
        const Camera down{{0.0, 0.0, 20.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 6.0 * kRadPerDeg};
        const FloatImage image = draw(scene, down, kSize, kSize);
        flux = steepest = 0.0;
        for (int y = 0; y < kSize; ++y) {
            for (int x = 1; x < kSize; ++x) {
                flux += image.at(x, y)[1];
                steepest = std::max(steepest,
                                    static_cast<double>(std::abs(image.at(x, y)[1] - image.at(x - 1, y)[1])));
            }
        }
    };
    double sharpFlux, sharpEdge, frostedFlux, frostedEdge;
    measure(0.0, sharpFlux, sharpEdge);
    measure(4.0, frostedFlux, frostedEdge);
    EXPECT_LT(frostedEdge, 0.25 * sharpEdge);
    EXPECT_NEAR(frostedFlux, sharpFlux, 0.08 * sharpFlux);
}

}  // namespace
}  // namespace hazer::test
