// Lamps with a photometric web as drawn: in the air against a quadrature of the web along the ray, on
// surfaces and in the lens against the web itself.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <random>
#include <string>

#include "render/camera.h"
#include "render/ies_web.h"
#include "render/mesh.h"
#include "render/photometry.h"
#include "tests/render/ies_text.h"
#include "tests/support/gl_test.h"

namespace hazer::test {
namespace {

using render::IesWeb;

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadPerDeg = kPi / 180.0;

IesWeb webOf(const IesText& file) {
    return render::parseIesWeb(file.text(), "test.ies");
}

/// As a parabolic lamp is measured: an oblong beam with stripes, and half a percent of stray light far out.
IesWeb oblongSpot() {
    IesText file;
    file.verticalDeg = anglesFrom(0.0, 90.0, 181);
    file.horizontalDeg = anglesFrom(0.0, 360.0, 73);
    file.candela = [](double h, double v) {
        const double wide = std::pow(std::sin(h * kRadPerDeg), 2.0);
        const double beam = std::exp2(-std::pow(v / (6.0 + 7.0 * wide), 2.5));
        const double stripes = 1.0 + 0.1 * std::cos(v * 0.9) * std::cos(4.0 * h * kRadPerDeg);
        return 80000.0 * (beam * stripes + 0.005 * std::max(std::cos(v * 1.2 * kRadPerDeg), 0.0));
    };
    return webOf(file);
}

/// As a wide washlight is measured: brightest well off the axis, and brighter to one side.
IesWeb sidewaysWash() {
    IesText file;
    file.verticalDeg = anglesFrom(0.0, 80.0, 33);
    file.horizontalDeg = anglesFrom(0.0, 360.0, 37);
    file.candela = [](double h, double v) {
        const double away = (v - 35.0) / 25.0;
        return 3000.0 * std::exp(-away * away) * (1.2 + std::cos(h * kRadPerDeg)) *
               std::min((80.0 - v) / 15.0, 1.0);
    };
    return webOf(file);
}

/// As a profile spot is measured: an edge of half a degree, scattered light beyond.
IesWeb hardEdge() {
    IesText file;
    file.verticalDeg = anglesFrom(0.0, 30.0, 121);
    file.candela = [](double, double v) {
        const double edge = std::clamp((15.5 - v) / 0.5, 0.0, 1.0);
        return 1e5 * (1.0 - 0.02 * v) * edge + 200.0 * std::exp(-v / 10.0);
    };
    return webOf(file);
}

/// A bright middle in a wide skirt.
IesWeb skirt() {
    IesText file;
    file.verticalDeg = anglesFrom(0.0, 90.0, 181);
    file.candela = [](double, double v) {
        return 1e5 * (std::exp2(-std::pow(v / 2.5, 2.0)) + 0.12 * std::exp2(-std::pow(v / 20.0, 2.0)));
    };
    return webOf(file);
}

/// Coarse steps and the noise of a meter.
IesWeb noisyWash() {
    IesText file;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> noise(0.9, 1.1);
    file.verticalDeg = anglesFrom(0.0, 90.0, 37);
    file.horizontalDeg = anglesFrom(0.0, 350.0, 36);
    file.candela = [&](double, double v) {
        return 2000.0 * std::pow(std::cos(v * kRadPerDeg), 3.0) * (v > 0.0 ? noise(random) : 1.0);
    };
    return webOf(file);
}

/// A bulb: every way, less upwards.
IesWeb bulb() {
    IesText file;
    file.verticalDeg = anglesFrom(0.0, 180.0, 37);
    file.candela = [](double, double v) { return 100.0 + 60.0 * std::cos(v * kRadPerDeg); };
    return webOf(file);
}

/// 50 % at 1 degree.
IesWeb pencil() {
    IesText file;
    file.verticalDeg = anglesFrom(0.0, 4.0, 81);
    file.candela = [](double, double v) { return 2e6 * std::exp2(-std::pow(v, 3.0)); };
    return webOf(file);
}

class WebGl : public GlTest {
 protected:
    /// A lamp at 6 m that shines down, of no size.
    render::Scene lampWith(const IesWeb& web) {
        render::Scene scene;
        render::Beam beam;
        beam.lensPositionM = {0.0, 0.0, 6.0};
        beam.lensRadiusM = 0.0;
        beam.web = renderer().addWeb(web);
        scene.beams.push_back(beam);
        return scene;
    }
};

/// The pixel's ray, in the world.
glm::dvec3 rayOf(const render::Camera& camera, int x, int y, int width, int height) {
    const glm::dvec2 tangent = render::viewTangent(camera, static_cast<double>(width) / height);
    const glm::dvec3 inView((2.0 * (x + 0.5) / width - 1.0) * tangent.x,
                            (1.0 - 2.0 * (y + 0.5) / height) * tangent.y, -1.0);
    return render::worldFromView(camera) * glm::normalize(inView);
}

double henyeyGreenstein(double cosine, double g) {
    return (1.0 - g * g) / (4.0 * kPi * std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5));
}

/// Relative intensity towards a direction of the lamp's frame.
using Intensity = std::function<double(const glm::dvec3&)>;

/// Single scattering along a ray from the lamp's own frame, by many even steps of the angle at the lamp.
double quadrature(const Intensity& relative, double peakCd, const render::Haze& haze, const glm::dvec3& lamp,
                  const glm::dvec3& eye, const glm::dvec3& direction) {
    constexpr int kSteps = 4000;
    const double nearest = glm::dot(lamp - eye, direction);
    const double h = glm::length(eye + nearest * direction - lamp);
    const double from = std::atan2(-nearest, h);
    const double step = (0.5 * kPi - from) / kSteps;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double u = from + (i + 0.5) * step;
        const double t = nearest + h * std::tan(u);
        const glm::dvec3 fromLamp = eye + t * direction - lamp;
        const double r = glm::length(fromLamp);
        const double cosine = -glm::dot(fromLamp, direction) / r;
        const render::PhaseFunction& phase = haze.phase;
        const double scattered = phase.forwardWeight * henyeyGreenstein(cosine, phase.forwardG) +
                                 (1.0 - phase.forwardWeight) * henyeyGreenstein(cosine, phase.backwardG);
        sum += relative(fromLamp) * scattered * std::exp(-haze.extinctionPerM * (t + r));
    }
    return peakCd * haze.scatteringPerM * sum * step / h;
}

Intensity towards(const IesWeb& web) {
    return [&web](const glm::dvec3& direction) { return web.relativeAt(direction); };
}

struct AirError {
    double rms = 0.0;  ///< Over that of the reference.
    double worst = 0.0;
};

/// At every `stride`-th pixel of every `stride`-th row.
AirError errorInAir(const render::FloatImage& image, const Intensity& relative, double peakCd,
                    const render::Scene& scene, const render::Camera& camera, int stride = 1) {
    double squares = 0.0;
    double reference = 0.0;
    AirError error;
    for (int y = stride / 2; y < image.height; y += stride) {
        for (int x = stride / 2; x < image.width; x += stride) {
            const double want = quadrature(relative, peakCd, scene.haze, scene.beams.front().lensPositionM,
                                           camera.positionM, rayOf(camera, x, y, image.width, image.height));
            const double off = image.at(x, y)[1] - want;
            squares += off * off;
            reference += want * want;
            error.worst = std::max(error.worst, std::abs(off) / want);
        }
    }
    error.rms = std::sqrt(squares / reference);
    return error;
}

/// A lamp of any pose: nothing about it is along an axis of the world.
render::Beam turned(render::Beam beam) {
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), 0.4, glm::normalize(glm::dvec3(1.0, -0.5, 0.8)));
    beam.worldFromBeam = glm::dmat3(turn);
    return beam;
}

TEST_F(WebGl, OnAFloorTheyAreCandelaOverSquaredDistance) {
    for (const auto& [name, web] :
         {std::pair<std::string, IesWeb>{"oblong spot", oblongSpot()}, {"sideways wash", sidewaysWash()}}) {
        render::Scene scene = lampWith(web);
        render::Beam& beam = scene.beams.front();
        beam = turned(beam);
        scene.haze.scatteringPerM = 0.0f;
        scene.haze.extinctionPerM = 0.02f;
        scene.instances.push_back({renderer().addMesh(render::makePlane()),
                                   glm::scale(glm::dmat4(1.0), glm::dvec3(40.0)),
                                   {render::Color(0.5f), 0.0f, 32.0f},
                                   false});
        const render::Camera camera{{0.0, -8.0, 5.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, 0.9};
        constexpr int kSize = 32;
        const render::FloatImage image = draw(scene, camera, kSize, kSize);
        int lit = 0;
        for (int y = kSize / 4; y < kSize; ++y) {
            for (int x = 0; x < kSize; ++x) {
                const glm::dvec3 ray = rayOf(camera, x, y, kSize, kSize);
                const double t = -camera.positionM.z / ray.z;
                const glm::dvec3 fromLamp = camera.positionM + t * ray - beam.lensPositionM;
                const double r = glm::length(fromLamp);
                const double candela =
                    web.peakCd * web.relativeAt(glm::transpose(beam.worldFromBeam) * fromLamp);
                const double lux = candela * (-fromLamp.z / r) / (r * r) * std::exp(-0.02 * (r + t));
                const double brightest = web.peakCd / 36.0 * 0.5 / kPi;
                EXPECT_NEAR(image.at(x, y)[1], lux * 0.5 / kPi, 1e-3 * brightest)
                    << name << " " << x << " " << y;
                if (lux * 0.5 / kPi > 0.01 * brightest) ++lit;
            }
        }
        EXPECT_GT(lit, 50) << name;
    }
}

TEST_F(WebGl, ABulbLightsWhatIsBehindIt) {
    render::Scene scene = lampWith(bulb());
    scene.haze.scatteringPerM = scene.haze.extinctionPerM = 0.0f;
    const glm::dmat4 ceiling = glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, 8.0)) *
                               glm::rotate(glm::dmat4(1.0), kPi, glm::dvec3(1.0, 0.0, 0.0));
    scene.instances.push_back({renderer().addMesh(render::makePlane()),
                               glm::scale(ceiling, glm::dvec3(20.0)),
                               {render::Color(0.5f), 0.0f, 32.0f},
                               false});
    const render::Camera camera{{0.0, 0.0, 1.0}, {0.0, 0.0, 8.0}, {0.0, 1.0, 0.0}, 0.2};
    // Straight up: 40 cd from 2 m.
    EXPECT_NEAR(draw(scene, camera, 9, 9).at(4, 4)[1], 40.0 / 4.0 * 0.5 / kPi, 0.01);
}

TEST_F(WebGl, ALensShowsTheIntensityTowardsTheEye) {
    const IesWeb web = sidewaysWash();
    render::Scene scene = lampWith(web);
    scene.haze.scatteringPerM = scene.haze.extinctionPerM = 0.0f;
    render::Beam& beam = scene.beams.front();
    beam.lensRadiusM = 0.3;
    for (const glm::dvec3& eye :
         {glm::dvec3(3.0, 0.5, 2.0), {-3.0, 0.5, 2.0}, {0.2, -0.1, 1.0}, {0.5, 3.0, 3.0}}) {
        const render::Camera camera{eye, beam.lensPositionM, {0.0, 1.0, 0.1}, 0.02};
        const double radiance = draw(scene, camera, 8, 8).at(4, 4)[1];
        const glm::dvec3 toEye = eye - beam.lensPositionM;
        const double cosine = -toEye.z / glm::length(toEye);
        const double stray = 2e-4;
        const double want = web.peakCd * (web.relativeAt(toEye) / cosine + stray) / (kPi * 0.09);
        EXPECT_NEAR(radiance / want, 1.0, 0.02);
    }
}

TEST_F(WebGl, TwoLampsHaveEachItsOwnWeb) {
    render::Scene scene = lampWith(pencil());
    render::Beam other = lampWith(sidewaysWash()).beams.front();
    const render::Camera camera{{0.0, -7.0, 2.5}, {0.0, 0.0, 3.5}, {0.0, 0.0, 1.0}, 0.9};
    render::Scene second = scene;
    second.beams = {other};
    render::Scene both = scene;
    both.beams.push_back(other);
    constexpr int kSize = 16;
    const render::Settings everyPixel{.airStep = 1};
    const render::FloatImage a = draw(scene, camera, kSize, kSize, everyPixel);
    const render::FloatImage b = draw(second, camera, kSize, kSize, everyPixel);
    const render::FloatImage sum = draw(both, camera, kSize, kSize, everyPixel);
    for (std::size_t i = 0; i < sum.rgb.size(); ++i) {
        EXPECT_NEAR(sum.rgb[i], a.rgb[i] + b.rgb[i], 1e-4f * (a.rgb[i] + b.rgb[i]) + 1e-9f);
    }
}

TEST_F(WebGl, InTheAirTheyAreTheIntegralOfTheWeb) {
    const render::Camera beside{{0.0, -7.0, 2.5}, {0.0, 0.0, 3.5}, {0.0, 0.0, 1.0}, 0.9};
    const render::Camera oblique{{5.0, -6.0, 1.0}, {0.0, 0.0, 4.0}, {0.0, 0.0, 1.0}, 0.9};
    const render::Camera below{{0.5, 0.3, 0.5}, {0.0, 0.0, 6.0}, {0.0, 1.0, 0.0}, 0.9};
    for (const auto& [name, web] : {std::pair<std::string, IesWeb>{"oblong spot", oblongSpot()},
                                    {"sideways wash", sidewaysWash()},
                                    {"hard edge", hardEdge()},
                                    {"skirt", skirt()},
                                    {"noisy wash", noisyWash()},
                                    {"bulb", bulb()},
                                    {"pencil", pencil()}}) {
        const render::Scene scene = lampWith(web);
        for (const render::Camera& camera : {beside, oblique, below}) {
            constexpr int kSize = 24;
            const AirError error = errorInAir(draw(scene, camera, kSize, kSize, {.airStep = 1}), towards(web),
                                              web.peakCd, scene, camera);
            fmt::print("{}: rms {:.2e}, worst {:.2e}\n", name, error.rms, error.worst);
            EXPECT_LE(error.rms, 0.01) << name;
        }
    }
}

TEST_F(WebGl, TheThesisMethodSeesThemToo) {
    const render::Camera beside{{0.0, -7.0, 2.5}, {0.0, 0.0, 3.5}, {0.0, 0.0, 1.0}, 0.9};
    render::Settings uniform{.integrator = render::Integrator::kUniform, .samples = 4096};
    for (const IesWeb& web : {sidewaysWash(), bulb()}) {
        const render::Scene scene = lampWith(web);
        const AirError error =
            errorInAir(draw(scene, beside, 24, 24, uniform), towards(web), web.peakCd, scene, beside);
        EXPECT_LE(error.rms, 0.02);
    }
}

TEST_F(WebGl, AGoboStandsInTheWebsLight) {
    const IesWeb web = oblongSpot();
    render::Scene scene = lampWith(web);
    // The right half is open.
    constexpr int kTexels = 64;
    std::vector<std::uint8_t> rgba;
    for (int i = 0; i < kTexels * kTexels; ++i) {
        const std::uint8_t value = i % kTexels >= kTexels / 2 ? 255 : 0;
        rgba.insert(rgba.end(), {value, value, value, 255});
    }
    scene.beams.front().gobo = renderer().addGobo(rgba.data(), kTexels, kTexels);
    const double edge = std::tan(web.fieldHalfAngleRad);
    const Intensity throughGobo = [&](const glm::dvec3& direction) {
        const glm::dvec2 tangent = glm::dvec2(direction) / -direction.z;
        const bool open = direction.z < 0.0 && tangent.x > 0.0 && glm::length(tangent) < edge;
        return open ? web.relativeAt(direction) : 0.0;
    };
    const render::Camera oblique{{5.0, -6.0, 1.0}, {0.0, 0.0, 4.0}, {0.0, 0.0, 1.0}, 0.9};
    // Fine pixels: a gobo is blurred by what a pixel sees of it.
    const AirError error = errorInAir(draw(scene, oblique, 720, 720, {.airStep = 1}), throughGobo, web.peakCd,
                                      scene, oblique, 30);
    fmt::print("rms {:.2e}\n", error.rms);
    EXPECT_LE(error.rms, 0.02);
}

}  // namespace
}  // namespace hazer::test
