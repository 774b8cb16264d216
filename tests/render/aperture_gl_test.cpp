// Composed apertures: what is in the picture, texel by texel, and that beams shine through it as through a
// gobo of the same.
#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "render/photometry.h"
#include "tests/support/gl_test.h"

namespace hazer::test {
namespace {

using render::Aperture;
using render::Beam;
using render::Camera;
using render::FloatImage;
using render::Scene;

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadPerDeg = kPi / 180.0;
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
        open_ = add([](const glm::dvec2& place) { return grey(glm::length(place) < 1.0); });
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
        beam.edge = edge_;
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

    struct Same {
        bool hasGobo = false;
        double brighter = 1.0;  ///< The lamp of the gobo is.
        double tolerance = 0.015;
    };

    /// The same light through an aperture and through a gobo that shows what the aperture should be.
    void expectSame(const Aperture& aperture, const Through& through, const char* what, const Same& same) {
        const auto [hasGobo, brighter, tolerance] = same;
        Scene scene = lamp();
        Beam& beam = scene.beams.front();
        beam.aperture = aperture;
        // Beyond a soft beam's field there is light unless a picture's gate is in the way, as in the gobo.
        if (!hasGobo && beam.aperture.images[3].gobo == -1) beam.aperture.images[3].gobo = open_;
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
        beam.fluxLm *= brighter;
        const FloatImage want = drawn(scene);
        EXPECT_LT(difference(got, want), tolerance) << what;
        beam.gobo = -1;
        EXPECT_GT(difference(drawn(scene), want), 0.1) << what << " does nothing";
    }

    void expectSame(const Aperture& aperture, const Through& through, const char* what) {
        expectSame(aperture, through, what, Same{});
    }

    render::BeamEdge edge_ = render::BeamEdge::kSoft;
    render::MeshId plane_ = -1;
    render::GoboId gobo_ = -1;
    render::GoboId open_ = -1;
};

TEST_F(ApertureGl, BladesCutFromTheirSide) {
    Aperture aperture;
    aperture.blades[0] = {turned({0.0, -1.0}, 0.3), 0.2};
    aperture.blades[2] = {{0.0, 1.0}, 0.5};
    const auto through = [](const glm::dvec2& place) {
        return grey(glm::dot(turned({0.0, -1.0}, 0.3), place) < 0.2 && place.y < 0.5);
    };
    expectSame(aperture, through, "blades");
    expectSame(aperture, through, "blades over a gobo", {.hasGobo = true});
}

TEST_F(ApertureGl, AnIrisClosesOverAGobo) {
    Aperture aperture;
    aperture.irisRadius = 0.6;
    expectSame(aperture, [](const glm::dvec2& place) { return grey(glm::length(place) < 0.6); }, "iris",
               {.hasGobo = true});
}

// A lamp's own shape takes no light: it comes out of a smaller area.
TEST_F(ApertureGl, ARectangleIsAsMuchBrighterAsItIsSmaller) {
    Aperture aperture;
    aperture.rectangle = {{0.8, 0.3}, 0.0};
    const double brighter = kPi / (4.0 * 0.8 * 0.3);
    expectSame(
        aperture,
        [](const glm::dvec2& place) { return grey(std::abs(place.x) < 0.8 && std::abs(place.y) < 0.3); },
        "rectangle", {.brighter = brighter});
    aperture.rectangle->softness = 0.3;
    const auto ramp = [](double place, double half) {
        return std::clamp((half - std::abs(place)) / 0.3, 0.0, 1.0);
    };
    expectSame(aperture,
               [&](const glm::dvec2& place) { return glm::dvec3(ramp(place.x, 0.8) * ramp(place.y, 0.3)); },
               "soft rectangle", {.brighter = kPi / (4.0 * 0.65 * 0.15)});
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
    expectSame(aperture, second, "both wheels", {.hasGobo = true});
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
        expectSame(aperture, through, "pictures", {.hasGobo = i % 2 == 1});
    }
}

// As through a cylindrical lens that stretches along a slanted axis, and mirrors.
TEST_F(ApertureGl, AStretchIsOfAllThatIsInTheWay) {
    const glm::dmat2 axes(turned({1.0, 0.0}, 0.4), turned({0.0, 1.0}, 0.4));
    Aperture aperture;
    aperture.stretch = axes * glm::dmat2(1.0, 0.0, 0.0, -0.4) * glm::transpose(axes);
    const glm::dmat2 back = glm::inverse(aperture.stretch);
    edge_ = render::BeamEdge::kFlat;
    // Edges are a texel wide along the shortest axis, which is more along the longest, and bright.
    const Same same{.brighter = 1.0 / 0.4, .tolerance = 0.06};
    expectSame(
        aperture, [&](const glm::dvec2& place) { return grey(glm::length(back * place) < 1.0); }, "field",
        same);
    aperture.images[0] = {gobo_, 0.3, {0.1, 0.0}, 1.0};
    aperture.blades[0] = {turned({0.0, -1.0}, 0.3), 0.2};
    expectSame(
        aperture,
        [&](const glm::dvec2& place) {
            const glm::dvec2 at = back * place;
            const bool isOpen = glm::dot(turned({0.0, -1.0}, 0.3), at) < 0.2 && glm::length(at) < 1.0;
            return quarter(turned(at - glm::dvec2(0.1, 0.0), -0.3)) * grey(isOpen);
        },
        "gobo and blade", same);
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

// Who looks into the beam sees the lens through what is in the way; the radiance is the intensity over the
// lens' area, and so is that of a copy whose beam is slanted.
TEST_F(ApertureGl, TheLensShowsWhatIsInTheWay) {
    const auto lensFrom = [&](double xM, const Beam& beam) {
        Scene scene = lamp();
        scene.haze.scatteringPerM = scene.haze.extinctionPerM = 0.0f;
        scene.beams[0] = beam;
        const Camera below{{xM, 0.0, 3.0}, {0.0, 0.0, 6.0}, {0.0, 1.0, 0.0}, 4.0 * kRadPerDeg};
        return static_cast<double>(draw(scene, below, 41, 41).at(20, 20)[1]);
    };
    Beam beam = lamp().beams[0];
    beam.showsLens = true;
    beam.edge = render::BeamEdge::kFlat;
    const double tangent = 0.3 / 3.0;
    const double open = lensFrom(0.3, beam);
    const double area = kPi * beam.lensRadiusM * beam.lensRadiusM;
    const double cosine = 1.0 / std::hypot(1.0, tangent);
    EXPECT_NEAR(open * area * cosine / render::beamShape(beam).peakCd, 1.0, 0.01);
    // At this scene +X is on the right of the beam's picture.
    beam.aperture.blades[0] = {{1.0, 0.0}, 0.1};
    EXPECT_LT(lensFrom(0.3, beam), 0.01 * open);
    EXPECT_NEAR(lensFrom(-0.3, beam) / open, 1.0, 0.02);
    beam.aperture = {};
    beam.worldFromBeam =
        glm::dmat3(glm::rotate(glm::dmat4(1.0), std::atan(tangent), glm::dvec3(0.0, -1.0, 0.0)));
    beam.lensNormal = glm::dvec3(0.0, 0.0, -1.0);
    EXPECT_NEAR(lensFrom(0.3, beam) / open, 1.0, 0.02);
}

/// Light on a floor 6 m below: lumens but for a factor, and its variance along x and y [m2].
struct OnFloor {
    double flux = 0.0;
    glm::dvec2 variance{0.0};
};

class FrostGl : public ApertureGl {
 protected:
    OnFloor measure(const Beam& beam) {
        constexpr double kHalfViewM = 2.6;
        Scene scene = lamp();
        scene.haze.scatteringPerM = 0.0f;
        scene.haze.extinctionPerM = 0.0f;
        scene.instances[0].material.specular = 0.0f;
        scene.beams[0] = beam;
        const Camera down{
            {0.0, 0.0, 60.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 2.0 * std::atan(kHalfViewM / 60.0)};
        const FloatImage image = draw(scene, down, kSize, kSize);
        OnFloor floor;
        glm::dvec2 first(0.0), second(0.0);
        for (int y = 0; y < kSize; ++y) {
            for (int x = 0; x < kSize; ++x) {
                const glm::dvec2 at =
                    kHalfViewM * (2.0 * glm::dvec2(x + 0.5, kSize - 0.5 - y) / double(kSize) - 1.0);
                const double light = image.at(x, y)[1];
                floor.flux += light;
                first += light * at;
                second += light * at * at;
            }
        }
        first /= floor.flux;
        floor.variance = second / floor.flux - first * first;
        return floor;
    }

    Beam narrowLamp() const {
        Beam beam = lamp().beams[0];
        beam.fieldAngleRad = 13.0 * kRadPerDeg;
        beam.beamAngleRad = 11.0 * kRadPerDeg;
        beam.edge = render::BeamEdge::kSoft;
        return beam;
    }

    /// Scattering keeps the light, and adds its own variance to that of whatever passes it.
    void expectScattered(Beam beam, const char* what) {
        const OnFloor sharp = measure(beam);
        for (const double frostDeg : {4.0, 8.0}) {
            beam.frostRad = frostDeg * kRadPerDeg;
            const OnFloor frosted = measure(beam);
            EXPECT_NEAR(frosted.flux / sharp.flux, 1.0, 0.03) << what << ", " << frostDeg;
            // A profile is made wider by the law of Gaussians, and a steep one is none.
            // Of a Gaussian of that width at half its peak, at 6 m.
            const double variance = std::pow(6.0 * beam.frostRad, 2.0) / (8.0 * std::log(2.0));
            for (int axis = 0; axis < 2; ++axis)
                EXPECT_NEAR((frosted.variance[axis] - sharp.variance[axis]) / variance, 1.0, 0.26)
                    << what << ", " << frostDeg << ", axis " << axis;
        }
    }
};

TEST_F(FrostGl, ScattersABareBeam) {
    expectScattered(narrowLamp(), "bare");
}

TEST_F(FrostGl, ScattersWhateverIsInTheWay) {
    Beam beam = narrowLamp();
    beam.aperture.irisRadius = 0.4;
    expectScattered(beam, "iris");
    beam = narrowLamp();
    beam.aperture.blades[0] = {{0.0, -1.0}, 0.2};
    expectScattered(beam, "blade");
    // A blade at the edge of the field changes nothing to speak of.
    beam.aperture.blades[0].distance = 0.99;
    beam.frostRad = 8.0 * kRadPerDeg;
    Beam bare = narrowLamp();
    bare.frostRad = beam.frostRad;
    EXPECT_NEAR(measure(beam).flux / measure(bare).flux, 1.0, 0.03);
    beam = narrowLamp();
    beam.gobo = gobo_;
    expectScattered(beam, "gobo");
    beam.edge = render::BeamEdge::kFlat;
    expectScattered(beam, "gobo of a flat beam");
}

TEST_F(FrostGl, ScattersTheBeamsOwnShape) {
    Beam beam = narrowLamp();
    beam.aperture.stretch = glm::dmat2(1.0, 0.0, 0.0, 0.4);
    expectScattered(beam, "oval");
    beam = narrowLamp();
    beam.edge = render::BeamEdge::kFlat;
    beam.aperture.rectangle = {{0.8, 0.6}, 0.1};
    expectScattered(beam, "rectangle");
}

// However a beam is shaped, its light is that of the round one; and without a gate there is light beyond the
// field, with or without a blade at its edge.
TEST_F(FrostGl, ShapesKeepTheLight) {
    Beam beam = narrowLamp();
    beam.beamAngleRad = 6.0 * kRadPerDeg;
    const double round = measure(beam).flux;
    beam.aperture.blades[0].distance = 0.99;
    EXPECT_NEAR(measure(beam).flux / round, 1.0, 0.03);
    beam.aperture = {};
    for (const double height : {1.0, 0.7, 0.3}) {
        beam.aperture.stretch = glm::dmat2(1.0, 0.0, 0.0, height);
        EXPECT_NEAR(measure(beam).flux / round, 1.0, 0.03) << height;
    }
    beam.aperture = {};
    beam.edge = render::BeamEdge::kFlat;
    for (const double softness : {0.0, 0.2, 0.5}) {
        beam.aperture.rectangle = {{0.8, 0.6}, softness};
        EXPECT_NEAR(measure(beam).flux / round, 1.0, 0.02) << softness;
    }
}

// A defocused gobo is as blurred as by the disc of light that the lens makes of a point.
TEST_F(FrostGl, DefocusIsTheDiscOfConfusion) {
    Beam beam = narrowLamp();
    beam.gobo = add([](const glm::dvec2& place) { return grey(glm::length(place) < 0.2); });
    beam.lensRadiusM = 0.08;
    const OnFloor sharp = measure(beam);
    beam.focusDistanceM = 3.0;
    const OnFloor blurred = measure(beam);
    EXPECT_NEAR(blurred.flux / sharp.flux, 1.0, 0.02);
    // Its radius on the floor is the lens' radius times 6 m * |1 / 6 m - 1 / 3 m|; a disc's variance along an
    // axis is a quarter of its radius squared. The apex behind the lens makes 6 m a little more.
    const double radiusM = 0.08 * 6.0 * (1.0 / 3.0 - 1.0 / 6.0);
    const double apexM = 6.0 + 0.08 / std::tan(6.5 * kRadPerDeg);
    const double variance = std::pow(radiusM * apexM / 6.0, 2.0) / 4.0;
    for (int axis = 0; axis < 2; ++axis)
        EXPECT_NEAR((blurred.variance[axis] - sharp.variance[axis]) / variance, 1.0, 0.25) << axis;
}

}  // namespace
}  // namespace hazer::test
