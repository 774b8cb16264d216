// Beams as drawn, pixel by pixel, against the oracle; and the faults that the thesis had.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "render/camera.h"
#include "render/gl/program.h"
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

constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;
constexpr int kSize = 64;

/// A lamp at 6 m that shines down, in plain haze over nothing.
Scene oneBeam() {
    Scene scene;
    Beam beam;
    beam.lensPositionM = {0.0, 0.0, 6.0};
    beam.lensRadiusM = 0.07;
    beam.fieldAngleRad = 30.0 * kRadPerDeg;
    beam.beamAngleRad = 20.0 * kRadPerDeg;
    beam.fluxLm = 10000.0;
    beam.edge = render::BeamEdge::kFlat;
    scene.beams.push_back(beam);
    return scene;
}

/// Does a ray meet the lens' disc, or the pixel around it? Lenses shine by themselves; the oracle knows the
/// air alone.
bool seesLens(const Beam& beam, const glm::dvec3& eye, const glm::dvec3& worldDirection, double pixelRad) {
    const double toLens = glm::dot(worldDirection, beam.lensPositionM - eye);
    const double missM = glm::length(eye + toLens * worldDirection - beam.lensPositionM);
    return toLens > 0.0 && missM < beam.lensRadiusM + 2.0 * pixelRad * toLens;
}

/// What the oracle says about a pixel's centre; NaN where the lens shows.
double expectedRadiance(const Scene& scene, const Camera& camera, int x, int y, int width, int height,
                        double endM) {
    const Beam& beam = scene.beams.front();
    const render::BeamShape shape = render::beamShape(beam);
    const glm::dvec2 tangent = render::viewTangent(camera, static_cast<double>(width) / height);
    const glm::dvec3 inView((2.0 * (x + 0.5) / width - 1.0) * tangent.x,
                            (1.0 - 2.0 * (y + 0.5) / height) * tangent.y, -1.0);
    const glm::dmat3 lampFromWorld = glm::transpose(beam.worldFromBeam);
    const glm::dvec3 worldDirection = render::worldFromView(camera) * glm::normalize(inView);
    if (seesLens(beam, camera.positionM, worldDirection, 2.0 * tangent.y / height)) return std::nan("");
    const glm::dvec3 direction = lampFromWorld * worldDirection;
    const glm::dvec3 apex = beam.lensPositionM + beam.worldFromBeam * glm::dvec3(0.0, 0.0, shape.apexToLensM);
    const render::oracle::BeamModel oracle{shape.cutHalfAngleRad, shape.beamHalfAngleRad, shape.exponent,
                                           render::glsl::Formulas<double>().PROFILE_CUT, shape.apexToLensM};
    const auto& haze = scene.haze;
    const render::oracle::HazeModel medium{haze.extinctionPerM, haze.scatteringPerM, haze.phase.forwardG,
                                           haze.phase.backwardG, haze.phase.forwardWeight};
    return shape.peakCd * render::oracle::airRadiance(
                              oracle, medium, {lampFromWorld * (camera.positionM - apex), direction, endM});
}

/// Compares every pixel with the oracle; `share` of the lit ones must be within `tolerance`, relative.
void expectOracle(const FloatImage& image, const Scene& scene, const Camera& camera, double tolerance,
                  double share) {
    std::vector<double> errors;
    double brightest = 0.0;
    std::vector<double> expected;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            expected.push_back(expectedRadiance(scene, camera, x, y, image.width, image.height, 2000.0));
            if (expected.back() > brightest) brightest = expected.back();
        }
    }
    ASSERT_GT(brightest, 0.0);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const double want = expected[static_cast<std::size_t>(y * image.width + x)];
            const double got = image.at(x, y)[1];
            ASSERT_TRUE(std::isfinite(got)) << "at " << x << ", " << y;
            if (std::isnan(want)) continue;
            if (want < 1e-6 * brightest) {
                EXPECT_LE(got, 1e-4 * brightest) << "light outside the beam at " << x << ", " << y;
            } else {
                errors.push_back(std::abs(got / want - 1.0));
            }
        }
    }
    std::sort(errors.begin(), errors.end());
    const auto index = static_cast<std::size_t>(share * static_cast<double>(errors.size() - 1));
    fmt::print("{} lit pixels, error {:.1e} at {} %, worst {:.1e}\n", errors.size(), errors[index],
               100.0 * share, errors.back());
    EXPECT_LE(errors[index], tolerance);
}

class BeamGl : public GlTest {
 protected:
    FloatImage drawBeam(const Scene& scene, const Camera& camera) {
        return draw(scene, camera, kSize, kSize);
    }
};

// Lenses would add their own light to the pixels they cover; these tests look at the air.
Camera from(const glm::dvec3& position, const glm::dvec3& target) {
    return {position, target, {0.0, 0.0, 1.0}, 45.0 * kRadPerDeg};
}

TEST_F(BeamGl, FromTheSide) {
    const Scene scene = oneBeam();
    const Camera camera = from({9.0, -3.0, 2.0}, {0.0, 0.0, 2.0});
    expectOracle(drawBeam(scene, camera), scene, camera, 1e-3, 0.99);
}

TEST_F(BeamGl, CameraInsideTheBeamSeesNoCutAndNoHole) {
    const Scene scene = oneBeam();
    for (const glm::dvec3& target :
         {glm::dvec3(0.3, 0.1, -50.0), glm::dvec3(5.0, 0.0, 2.0), glm::dvec3(-3.0, 2.0, 6.5)}) {
        const Camera camera = from({0.2, 0.1, 2.0}, target);
        expectOracle(drawBeam(scene, camera), scene, camera, 1e-3, 0.99);
    }
}

// The near plane of the thesis cut a beam that points at the camera.
TEST_F(BeamGl, BeamPointedAtTheCamera) {
    Scene scene = oneBeam();
    Beam& beam = scene.beams.front();
    beam.lensPositionM = {0.0, 12.0, 3.0};
    beam.worldFromBeam =
        glm::dmat3(glm::rotate(glm::dmat4(1.0), -90.0 * kRadPerDeg, glm::dvec3(1.0, 0.0, 0.0)));
    ASSERT_NEAR((beam.worldFromBeam * glm::dvec3(0.0, 0.0, -1.0)).y, -1.0, 1e-12);
    // A lens of no size draws no disc, so that the pixels hold the air alone; the point source makes the air
    // unbounded at its centre, so the camera looks past it by a degree.
    beam.lensRadiusM = 0.0;
    const Camera camera = from({0.1, 0.0, 3.05}, {0.35, 12.0, 3.2});
    const FloatImage image = drawBeam(scene, camera);
    expectOracle(image, scene, camera, 1e-3, 0.97);
}

TEST_F(BeamGl, KilometresFromTheOrigin) {
    Scene scene = oneBeam();
    const glm::dvec3 far(100000.0, -50000.0, 200.0);
    scene.beams.front().lensPositionM += far;
    const Camera camera = from(far + glm::dvec3(9.0, -3.0, 2.0), far + glm::dvec3(0.0, 0.0, 2.0));
    expectOracle(drawBeam(scene, camera), scene, camera, 1e-3, 0.99);
}

TEST_F(BeamGl, NarrowAndWide) {
    for (const double fieldDeg : {0.5, 2.0, 60.0, 110.0, 150.0}) {
        Scene scene = oneBeam();
        scene.beams.front().fieldAngleRad = fieldDeg * kRadPerDeg;
        // Just past the beam's foot, so that something narrow still fills pixels.
        const Camera camera = fieldDeg < 10.0 ? from({0.9, 0.0, 3.0}, {0.0, 0.0, 3.0})
                                              : from({9.0, -3.0, 2.0}, {0.0, 0.0, 2.0});
        SCOPED_TRACE(fieldDeg);
        expectOracle(drawBeam(scene, camera), scene, camera, 2e-3, 0.97);
    }
}

// Whatever looks along, through or into whatever: numbers stay numbers.
TEST_F(BeamGl, ExtremeViewsStayFinite) {
    for (const double fieldDeg : {0.05, 1.0, 45.0, 178.0}) {
        for (const double extinction : {0.0, 0.01, 10.0}) {
            Scene scene = oneBeam();
            scene.beams.front().fieldAngleRad = fieldDeg * kRadPerDeg;
            scene.beams.front().fluxLm = 1e9;
            scene.haze.extinctionPerM = static_cast<float>(extinction);
            scene.haze.scatteringPerM = 0.01f;
            for (const glm::dvec3& eye :
                 {glm::dvec3(0.0, 0.0, 6.0), glm::dvec3(0.0, 0.0, 6.5), glm::dvec3(0.0, 0.0, -3.0),
                  glm::dvec3(0.0, 0.0, 5.999), glm::dvec3(1e5, 0.0, 0.0)}) {
                for (const glm::dvec3& target :
                     {glm::dvec3(0.0, 0.0, 20.0), glm::dvec3(0.0, 0.0, -20.0), glm::dvec3(7.0, 0.0, 6.0)}) {
                    const FloatImage image = draw(scene, from(eye, target), 16, 16);
                    EXPECT_TRUE(std::all_of(image.rgb.begin(), image.rgb.end(),
                                            [](float v) { return std::isfinite(v); }))
                        << "field " << fieldDeg << " deg, extinction " << extinction;
                }
            }
        }
    }
}

TEST_F(BeamGl, TwoBeamsThatCrossAddUp) {
    Scene both = oneBeam();
    Beam second = both.beams.front();
    second.lensPositionM = {-3.0, 0.0, 5.0};
    second.worldFromBeam =
        glm::dmat3(glm::rotate(glm::dmat4(1.0), -40.0 * kRadPerDeg, glm::dvec3(0.0, 1.0, 0.0)));
    second.color = {0.4f, 1.2f, 0.6f};
    both.beams.push_back(second);
    Scene first = both, other = both;
    first.beams.pop_back();
    other.beams.erase(other.beams.begin());
    const Camera camera = from({1.0, -9.0, 2.0}, {0.0, 0.0, 2.5});
    const FloatImage sum = drawBeam(both, camera), a = drawBeam(first, camera), b = drawBeam(other, camera);
    int crossed = 0;
    for (std::size_t i = 0; i < sum.rgb.size(); ++i) {
        EXPECT_NEAR(sum.rgb[i], a.rgb[i] + b.rgb[i],
                    1e-5f * (std::abs(a.rgb[i]) + std::abs(b.rgb[i])) + 1e-7f);
        if (a.rgb[i] > 0.0f && b.rgb[i] > 0.0f) ++crossed;
    }
    EXPECT_GT(crossed, 100);
}

TEST_F(BeamGl, UniformIntegratorAgreesOnAWideBeam) {
    const Scene scene = oneBeam();
    const Camera camera = from({9.0, -3.0, 2.0}, {0.0, 0.0, 2.0});
    render::Settings settings;
    const FloatImage angle = draw(scene, camera, kSize, kSize, settings);
    settings.integrator = render::Integrator::kUniform;
    settings.samples = 4000;
    const FloatImage uniform = draw(scene, camera, kSize, kSize, settings);
    double difference = 0.0, total = 0.0;
    for (std::size_t i = 0; i < angle.rgb.size(); ++i) {
        difference += std::abs(angle.rgb[i] - uniform.rgb[i]);
        total += std::abs(angle.rgb[i]);
    }
    EXPECT_LT(difference, 0.02 * total);
}

TEST_F(BeamGl, EveryShaderVariantCompiles) {
    const auto compile = [](const char* fragments, render::LightFeatures features) {
        EXPECT_NO_THROW(
            render::gl::Program(shaderFolder(), "beam.vert", fragments, render::featureDefines(features)));
    };
    for (const auto features : render::allAirVariants()) compile("air.frag", features);
    for (const auto features : render::allSurfaceVariants()) compile("lit_surface.frag", features);
}

}  // namespace
}  // namespace hazer::test
