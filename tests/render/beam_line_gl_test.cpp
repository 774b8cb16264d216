// Beams thinner than pixels, drawn: their light against the oracle's, at every place of their length.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "render/camera.h"
#include "render/glsl_as_cpp.h"
#include "render/oracle/single_beam.h"
#include "render/photometry.h"
#include "render/scene_plan.h"
#include "tests/support/gl_test.h"

namespace hazer::test {
namespace {

using render::Beam;
using render::Camera;
using render::FloatImage;
using render::Scene;

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadPerDeg = kPi / 180.0;
constexpr int kSize = 128;

/// A lamp at 6 m that shines down.
Scene thinBeam(double halfAngleDeg, double lensRadiusM) {
    Scene scene;
    Beam beam;
    beam.lensPositionM = {0.0, 0.0, 6.0};
    beam.lensRadiusM = lensRadiusM;
    beam.fieldAngleRad = 2.0 * halfAngleDeg * kRadPerDeg;
    beam.beamAngleRad = beam.fieldAngleRad;
    beam.edge = render::BeamEdge::kFlat;
    beam.fluxLm = 10000.0;
    beam.showsLens = false;
    scene.beams.push_back(beam);
    return scene;
}

/// `rolledDeg`: how far the picture is turned.
Camera sideCamera(double rolledDeg) {
    const double rolled = rolledDeg * kRadPerDeg;
    Camera camera{{7.0, -5.0, 2.5}, {0.0, 0.0, 3.0}, {0.0, 0.0, 1.0}, 50.0 * kRadPerDeg};
    const glm::dvec3 forward = glm::normalize(camera.targetM - camera.positionM);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    camera.up = std::cos(rolled) * camera.up + std::sin(rolled) * right;
    return camera;
}

double pixelTangent(const Camera& camera) {
    return 2.0 * render::viewTangent(camera, 1.0).y / kSize;
}

/// Where a point is in the picture [px], row 0 on top, and how deep [m].
glm::dvec3 pictureOf(const Camera& camera, const glm::dvec3& pointM) {
    const glm::dvec3 view = glm::transpose(render::worldFromView(camera)) * (pointM - camera.positionM);
    return {0.5 * kSize + view.x / -view.z / pixelTangent(camera),
            0.5 * kSize - view.y / -view.z / pixelTangent(camera), -view.z};
}

/// The ray through a place of the picture [px].
double oracleRadiance(const Scene& scene, const Camera& camera, const glm::dvec2& place) {
    const Beam& beam = scene.beams.front();
    const render::BeamShape shape = render::beamShape(beam);
    const double pixel = pixelTangent(camera);
    const glm::dvec3 inView((place.x - 0.5 * kSize) * pixel, (0.5 * kSize - place.y) * pixel, -1.0);
    const glm::dmat3 lampFromWorld = glm::transpose(beam.worldFromBeam);
    const glm::dvec3 apexM =
        beam.lensPositionM + beam.worldFromBeam * glm::dvec3(0.0, 0.0, shape.apexToLensM);
    const auto& haze = scene.haze;
    return shape.peakCd *
           render::oracle::airRadiance(
               {shape.cutHalfAngleRad, shape.beamHalfAngleRad, shape.exponent,
                render::glsl::Formulas<double>().PROFILE_CUT, shape.apexToLensM},
               {haze.extinctionPerM, haze.scatteringPerM, haze.phase.forwardG, haze.phase.backwardG,
                haze.phase.forwardWeight},
               {lampFromWorld * (camera.positionM - apexM),
                lampFromWorld * (render::worldFromView(camera) * glm::normalize(inView)), 1e5});
}

/// A stretch of a beam in the picture: what is counted fades out smoothly to both sides of its middle.
struct Stretch {
    glm::dvec2 middle{0.0};
    glm::dvec2 along{1.0, 0.0};
    double radiusPx = 0.0;

    static constexpr double kHalfLength = 12.0;  // px
    static double weight(double alongPx) {
        const double wave = std::cos(0.5 * kPi * alongPx / kHalfLength);
        return std::abs(alongPx) < kHalfLength ? wave * wave : 0.0;
    }
};

Stretch stretchAt(const Scene& scene, const Camera& camera, double fromLensM) {
    const Beam& beam = scene.beams.front();
    const glm::dvec3 axis = beam.worldFromBeam * glm::dvec3(0.0, 0.0, -1.0);
    const glm::dvec3 here = pictureOf(camera, beam.lensPositionM + fromLensM * axis);
    const glm::dvec3 there = pictureOf(camera, beam.lensPositionM + (fromLensM + 0.01) * axis);
    const render::BeamShape shape = render::beamShape(beam);
    const double radiusM = (fromLensM + shape.apexToLensM) * std::tan(shape.cutHalfAngleRad);
    return {glm::dvec2(here), glm::normalize(glm::dvec2(there - here)),
            radiusM / here.z / pixelTangent(camera)};
}

double drawnLight(const FloatImage& image, const Stretch& stretch) {
    double sum = 0.0;
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const double alongPx = glm::dot(glm::dvec2(x + 0.5, y + 0.5) - stretch.middle, stretch.along);
            sum += Stretch::weight(alongPx) * static_cast<double>(image.at(x, y)[1]);
        }
    }
    return sum;
}

double oracleLight(const Scene& scene, const Camera& camera, const Stretch& stretch) {
    constexpr int kAlong = 12;
    constexpr int kAcross = 48;
    const glm::dvec2 across(stretch.along.y, -stretch.along.x);
    const double widest = 1.6 * stretch.radiusPx;
    double sum = 0.0;
    for (int i = 0; i < kAlong; ++i) {
        const double alongPx = Stretch::kHalfLength * (2.0 * (i + 0.5) / kAlong - 1.0);
        for (int k = 0; k < kAcross; ++k) {
            const double angle = kPi * (k + 0.5) / kAcross;
            const glm::dvec2 place =
                stretch.middle + alongPx * stretch.along + widest * std::cos(angle) * across;
            sum += Stretch::weight(alongPx) * std::sin(angle) * oracleRadiance(scene, camera, place);
        }
    }
    return sum * kPi / kAcross * widest * 2.0 * Stretch::kHalfLength / kAlong;
}

class BeamLineGl : public GlTest {
 protected:
    double drawnOverOracle(const Scene& scene, const Camera& camera, double fromLensM) {
        const Stretch stretch = stretchAt(scene, camera, fromLensM);
        return drawnLight(draw(scene, camera, kSize, kSize), stretch) / oracleLight(scene, camera, stretch);
    }
};

bool isLine(const Scene& scene, const Camera& camera) {
    render::Settings settings;
    settings.width = settings.height = kSize;
    return render::usesFeature(render::planScene(scene, camera, settings, {}), render::kFeatureLine);
}

// From a hundredth of a pixel to ten of them, without a step where lines give way to rays.
TEST_F(BeamLineGl, NoLightIsLostOrGainedAtAnyAngle) {
    for (const render::BeamEdge edge : {render::BeamEdge::kFlat, render::BeamEdge::kSoft}) {
        double worst = 0.0;
        for (double halfDeg = 0.01; halfDeg < 2.1; halfDeg *= 1.25) {
            Scene scene = thinBeam(halfDeg, 0.0);
            scene.beams.front().edge = edge;
            scene.beams.front().beamAngleRad *= edge == render::BeamEdge::kSoft ? 0.6 : 1.0;
            const double ratio = drawnOverOracle(scene, sideCamera(17.0), 3.5);
            EXPECT_NEAR(ratio, 1.0, 0.02)
                << halfDeg << " degrees, drawn as a line: " << isLine(scene, sideCamera(17.0));
            worst = std::max(worst, std::abs(ratio - 1.0));
        }
        fmt::print("0.01 to 2 degrees: drawn over oracle differs from 1 by at most {:.1e}\n", worst);
    }
    EXPECT_TRUE(isLine(thinBeam(0.01, 0.0), sideCamera(17.0)));
    EXPECT_FALSE(isLine(thinBeam(2.0, 0.0), sideCamera(17.0)));
}

TEST_F(BeamLineGl, HoweverTheBeamLies) {
    double worst = 0.0;
    for (const double rolledDeg : {0.0, 7.0, 26.6, 45.0, 90.0}) {
        for (const double fromLensM : {1.0, 2.5, 4.0}) {
            for (const double lensRadiusM : {0.0, 0.02}) {
                const Scene scene = thinBeam(0.1, lensRadiusM);
                const double ratio = drawnOverOracle(scene, sideCamera(rolledDeg), fromLensM);
                EXPECT_NEAR(ratio, 1.0, 0.015) << rolledDeg << " degrees, " << fromLensM << " m";
                worst = std::max(worst, std::abs(ratio - 1.0));
            }
        }
    }
    fmt::print("as it lies: at most {:.1e}\n", worst);
}

TEST_F(BeamLineGl, FromAfarAndNearlyAlongTheBeam) {
    const Camera afar{{120.0, -90.0, 40.0}, {0.0, 0.0, 3.0}, {0.1, 0.0, 1.0}, 5.0 * kRadPerDeg};
    const Camera along{{0.6, -0.5, -6.0}, {0.0, 0.0, 5.0}, {0.3, 1.0, 0.0}, 12.0 * kRadPerDeg};
    for (const double halfDeg : {0.01, 0.05, 0.2}) {
        EXPECT_NEAR(drawnOverOracle(thinBeam(halfDeg, 0.01), afar, 3.0), 1.0, 0.015) << halfDeg;
        EXPECT_NEAR(drawnOverOracle(thinBeam(halfDeg, 0.01), along, 6.0), 1.0, 0.015) << halfDeg;
    }
}

TEST_F(BeamLineGl, AHundredKilometresFromTheOrigin) {
    const glm::dvec3 farM(1e5, -5e4, 10.0);
    Scene scene = thinBeam(0.01, 0.02);
    scene.beams.front().lensPositionM += farM;
    Camera camera = sideCamera(17.0);
    camera.positionM += farM;
    camera.targetM += farM;
    EXPECT_NEAR(drawnOverOracle(scene, camera, 3.5), 1.0, 0.015);
}

// In clear isotropic haze the light of an axis in line with the eye is sigma flux / (4 pi) times the integral
// of ds / D^2, which is 1 / D at the lens less 1 / D at the end, a kilometre on.
TEST_F(BeamLineGl, SeenFromBehindTheBeamIsADot) {
    Scene scene = thinBeam(0.05, 0.0);
    scene.haze.phase = {0.0f, 0.0f, 1.0f};
    scene.haze.extinctionPerM = 0.0f;
    scene.haze.scatteringPerM = 0.02f;
    for (const glm::dvec2& aside : {glm::dvec2(0.0), glm::dvec2(0.003, 0.001), glm::dvec2(0.05, -0.1)}) {
        const Camera camera{{aside.x, aside.y, 46.0}, {0.1, 0.2, 0.0}, {0.0, 1.0, 0.0}, 40.0 * kRadPerDeg};
        const FloatImage image = draw(scene, camera, kSize, kSize);
        double sum = 0.0;
        for (int y = 0; y < kSize; ++y) {
            for (int x = 0; x < kSize; ++x) sum += static_cast<double>(image.at(x, y)[1]);
        }
        const double pixel = pixelTangent(camera);
        const double expected = 0.02 * 10000.0 / (4.0 * kPi) * (1.0 / 40.0 - 1.0 / 1040.0);
        EXPECT_NEAR(sum * pixel * pixel / expected, 1.0, 0.02) << aside.x;
    }
}

TEST_F(BeamLineGl, AGoboCountsByItsMean) {
    constexpr std::size_t kTexels = 64;
    std::vector<std::uint8_t> rgba(4 * kTexels * kTexels, 255);
    for (std::size_t i = 0; i < kTexels * kTexels; ++i) {
        if (i % kTexels < kTexels / 2)
            std::fill_n(rgba.begin() + static_cast<std::ptrdiff_t>(4 * i), 3, std::uint8_t{0});
    }
    Scene scene = thinBeam(0.05, 0.0);
    const Camera camera = sideCamera(17.0);
    const Stretch stretch = stretchAt(scene, camera, 3.0);
    const double open = drawnLight(draw(scene, camera, kSize, kSize), stretch);
    scene.beams.front().gobo =
        renderer().addGobo(rgba.data(), static_cast<int>(kTexels), static_cast<int>(kTexels));
    EXPECT_NEAR(drawnLight(draw(scene, camera, kSize, kSize), stretch) / open, 0.5, 0.01);
}

TEST_F(BeamLineGl, BodiesHideIt) {
    Scene scene = thinBeam(0.05, 0.0);
    const Camera camera = sideCamera(17.0);
    const FloatImage open = draw(scene, camera, kSize, kSize);
    const Stretch above = stretchAt(scene, camera, 1.5);
    const Stretch below = stretchAt(scene, camera, 4.5);
    render::MeshInstance body;
    body.mesh = renderer().addMesh(render::makeBox());
    body.material.albedo = render::Color(0.0f);
    body.material.specular = 0.0f;
    body.worldFromMesh = glm::scale(glm::translate(glm::dmat4(1.0), {0.0, 0.0, 3.0}), glm::dvec3(0.2));
    scene.instances.push_back(body);
    const FloatImage shaded = draw(scene, camera, kSize, kSize);
    EXPECT_NEAR(drawnLight(shaded, above) / drawnLight(open, above), 1.0, 1e-3);
    EXPECT_LT(drawnLight(shaded, below), 1e-6 * drawnLight(open, below));
    // Between the eye and the beam.
    scene.instances.front().castsShadow = false;
    scene.instances.front().worldFromMesh =
        glm::scale(glm::translate(glm::dmat4(1.0), {3.5, -2.5, 3.5}), glm::dvec3(1.0));
    const FloatImage hidden = draw(scene, camera, kSize, kSize);
    EXPECT_LT(drawnLight(hidden, above), 1e-6 * drawnLight(open, above));
}

}  // namespace
}  // namespace hazer::test
