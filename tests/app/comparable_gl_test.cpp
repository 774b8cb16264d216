// A show given by numbers, drawn by the real program: every pixel of the EXR against the integral and the law
// that the numbers stand for (docs/comparison.md), worked out anew in double from plain geometry.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

#include "app/paths.h"
#include "render/image.h"
#include "render/oracle/single_beam.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace hazer::app {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kWidth = 48;
constexpr int kHeight = 32;

/// What a comparable show consists of; as it stands, app/shows/comparable.toml from its first camera.
struct Numbers {
    double extinctionPerM = 0.05, scatteringPerM = 0.04, g = 0.7;
    glm::dvec3 lampM{0.0, 0.0, 6.0}, lampTargetM{0.5, 0.3, 0.0};
    double candela = 10000.0, halfAngleDeg = 16.0;
    double beamHalfAngleDeg = 0.0;  // 0: a flat beam
    double lensRadiusM = 0.0;
    glm::dvec3 color{1.0, 1.0, 1.0}, albedo{0.6, 0.5, 0.3};
    glm::dvec3 eyeM{1.5, -8.0, 2.6}, eyeTargetM{0.3, 0.0, 2.6};
    double fovDeg = 40.0;
};

std::string toml(const glm::dvec3& v) {
    return fmt::format("[{}, {}, {}]", v.x, v.y, v.z);
}

std::string showOf(const Numbers& n) {
    const std::string profile =
        n.beamHalfAngleDeg > 0.0 ? fmt::format("'soft'\nbeam_half_angle={}", n.beamHalfAngleDeg) : "'flat'";
    return fmt::format(
        "[haze]\nextinction={}\nscattering={}\nphase={{g={}}}\n"
        "[[camera]]\nname='c'\nposition={}\ntarget={}\nfov={}\n"
        "[[light]]\nname='key'\nposition={}\ntarget={}\ncandela={}\nhalf_angle={}\nprofile={}\n"
        "lens_radius={}\ncolor={}\n"
        "[[object]]\ntype='floor'\nsize=[80,80]\nspecular=0\nalbedo={}\n",
        n.extinctionPerM, n.scatteringPerM, n.g, toml(n.eyeM), toml(n.eyeTargetM), n.fovDeg, toml(n.lampM),
        toml(n.lampTargetM), n.candela, n.halfAngleDeg, profile, n.lensRadiusM, toml(n.color),
        toml(n.albedo));
}

/// The beam as the oracle has it, for 1 cd.
render::oracle::BeamModel beamOf(const Numbers& n) {
    constexpr double kPedestal = 0.005;
    render::oracle::BeamModel beam;
    const double field = n.halfAngleDeg * kPi / 180.0;
    beam.cutHalfAngleRad = beam.beamHalfAngleRad = field;
    // A lamp that shines backwards, too, has no lens plane.
    beam.apexToLensM = n.halfAngleDeg < 89.0 ? n.lensRadiusM / std::tan(field) : 0.0;
    if (n.beamHalfAngleDeg > 0.0) {
        beam.beamHalfAngleRad = n.beamHalfAngleDeg * kPi / 180.0;
        beam.exponent = std::log(std::log(10.0) / std::log(2.0)) / std::log(field / beam.beamHalfAngleRad);
        beam.profileCut = kPedestal;
        beam.cutHalfAngleRad =
            std::min(beam.beamHalfAngleRad * std::pow(std::log2(1.0 / kPedestal), 1.0 / beam.exponent),
                     kPi * 179.0 / 180.0);
    }
    return beam;
}

double intensity(const render::oracle::BeamModel& beam, double psi) {
    if (psi > beam.cutHalfAngleRad) return 0.0;
    if (beam.exponent == 0.0) return 1.0;
    const double gauss = std::pow(0.5, std::pow(psi / beam.beamHalfAngleRad, beam.exponent));
    return std::max(gauss - beam.profileCut, 0.0) / (1.0 - beam.profileCut);
}

/// Unit vector from the eye through the middle of a pixel.
glm::dvec3 pixelRay(const Numbers& n, int x, int y) {
    const glm::dvec3 forward = glm::normalize(n.eyeTargetM - n.eyeM);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0.0, 0.0, 1.0)));
    const glm::dvec3 up = glm::cross(right, forward);
    const double tangent = std::tan(0.5 * n.fovDeg * kPi / 180.0);
    return glm::normalize(forward + right * (((2.0 * x + 1.0) / kWidth - 1.0) * tangent * kWidth / kHeight) +
                          up * ((1.0 - (2.0 * y + 1.0) / kHeight) * tangent));
}

/// Reflected by the floor z = 0 at `t` metres along the ray: I cos / r^2 * exp(-extinction * way) * albedo /
/// pi.
glm::dvec3 floorRadiance(const Numbers& n, const render::oracle::BeamModel& beam, const glm::dvec3& apexM,
                         const glm::dvec3& axis, const glm::dvec3& pointM, double t) {
    const glm::dvec3 way = pointM - apexM;
    const double r = glm::length(way);
    const double cosAxis = glm::dot(way, axis) / r;
    const double lux =
        n.candela * intensity(beam, std::acos(std::min(cosAxis, 1.0))) * (-way.z / r) / (r * r);
    const double lensToFloorM = r - beam.apexToLensM / cosAxis;
    return n.albedo * (lux / kPi * std::exp(-n.extinctionPerM * (lensToFloorM + t)));
}

/// What a pixel must hold [cd/m^2].
glm::dvec3 expected(const Numbers& n, int x, int y) {
    const render::oracle::BeamModel beam = beamOf(n);
    const render::oracle::HazeModel haze{n.extinctionPerM, n.scatteringPerM, n.g, 0.0, 1.0};
    const glm::dvec3 axis = glm::normalize(n.lampTargetM - n.lampM);
    const glm::dvec3 apexM = n.lampM - axis * beam.apexToLensM;
    const glm::dvec3 side = glm::normalize(glm::cross(axis, glm::dvec3(0.31, 0.94, 0.1)));
    const glm::dmat3 lampFromWorld = glm::transpose(glm::dmat3(side, glm::cross(side, axis), -axis));
    const glm::dvec3 ray = pixelRay(n, x, y);
    const bool meetsFloor = ray.z < 0.0;
    const double endM = meetsFloor ? -n.eyeM.z / ray.z : 1000.0;
    glm::dvec3 light(n.candela *
                     render::oracle::airRadiance(
                         beam, haze, {lampFromWorld * (n.eyeM - apexM), lampFromWorld * ray, endM}));
    if (meetsFloor) light += floorRadiance(n, beam, apexM, axis, n.eyeM + ray * endM, endM);
    // Luminance of the Rec. 709 primaries (ITU-R BT.709): a coloured light has the candela of a white one.
    return light * n.color / glm::dot(n.color, glm::dvec3(0.2126, 0.7152, 0.0722));
}

/// hazer over expected, of all lit pixels and colours: sorted distances from 1, and the mean.
struct Ratios {
    std::vector<double> errors;
    double mean = 0.0;
};

Ratios ratiosOf(const render::FloatImage& image, const Numbers& n) {
    std::vector<double> want;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const glm::dvec3 light = expected(n, x, y);
            want.insert(want.end(), {light.r, light.g, light.b});
        }
    }
    const double brightest = *std::max_element(want.begin(), want.end());
    Ratios ratios;
    for (std::size_t i = 0; i < want.size(); ++i) {
        const double got = image.rgb[i];
        if (want[i] <= 1e-4 * brightest) {
            EXPECT_LE(std::abs(got), 2e-4 * brightest) << "light where there is none, value " << i;
            continue;
        }
        ratios.errors.push_back(std::abs(got / want[i] - 1.0));
        ratios.mean += got / want[i];
    }
    ratios.mean /= static_cast<double>(ratios.errors.size());
    std::sort(ratios.errors.begin(), ratios.errors.end());
    return ratios;
}

class Comparable : public ::testing::Test {
 protected:
    /// The EXR of a show, or nothing and a failure.
    render::FloatImage drawn(const std::string& show, std::vector<std::string> more = {}) {
        const std::string out = (folder_.path() / "a.exr").string();
        more.insert(more.begin(),
                    {"render", show, "--size", fmt::format("{}x{}", kWidth, kHeight), "--out", out});
        const test::ProcessResult result = test::runProcess(HAZER_PROGRAM, more);
        EXPECT_EQ(result.exitCode, 0) << result.errors;
        return result.exitCode == 0 ? render::readFloatImage(out) : render::FloatImage{};
    }

    void expectEquation(const render::FloatImage& image, const Numbers& n) {
        ASSERT_EQ(image.rgb.size(), std::size_t{3} * kWidth * kHeight);
        const Ratios ratios = ratiosOf(image, n);
        ASSERT_GT(ratios.errors.size(), 300u);
        const double error99 = ratios.errors[ratios.errors.size() * 99 / 100];
        fmt::print("{} lit values, mean ratio {:.6f}, error {:.1e} at 99 %, worst {:.1e}\n",
                   ratios.errors.size(), ratios.mean, error99, ratios.errors.back());
        EXPECT_NEAR(ratios.mean, 1.0, 1e-3);
        EXPECT_LE(error99, 2e-3);
    }

    std::string written(const Numbers& n) const { return folder_.write("a.toml", showOf(n)).string(); }

    const test::TemporaryFolder folder_;
};

TEST_F(Comparable, theShowThatComesWithHazer) {
    const std::string show = (showFolder() / "comparable.toml").string();
    Numbers numbers;
    expectEquation(drawn(show, {"--camera", "outside"}), numbers);
    numbers.eyeM = {0.3, -0.2, 2.5};
    numbers.eyeTargetM = {2.5, 1.5, 3.2};
    numbers.fovDeg = 60.0;
    expectEquation(drawn(show, {"--camera", "inside the cone"}), numbers);
    numbers.eyeM = {-1.6, -3.0, 3.4};
    numbers.eyeTargetM = {0.5, 0.3, 0.0};
    numbers.fovDeg = 36.0;
    expectEquation(drawn(show, {"--camera", "onto the floor"}), numbers);
}

TEST_F(Comparable, softBeams) {
    Numbers numbers;
    numbers.beamHalfAngleDeg = 11.0;
    expectEquation(drawn(written(numbers)), numbers);
    numbers.eyeM = {0.3, -0.2, 2.5};
    numbers.eyeTargetM = {2.5, 1.5, 3.2};
    expectEquation(drawn(written(numbers)), numbers);
}

TEST_F(Comparable, lensesWithASize) {
    Numbers numbers;
    numbers.lensRadiusM = 0.2;
    expectEquation(drawn(written(numbers)), numbers);
    numbers.beamHalfAngleDeg = 12.0;
    numbers.lensRadiusM = 0.05;
    expectEquation(drawn(written(numbers)), numbers);
}

TEST_F(Comparable, hazeFromThinToThickAndFromBackwardToForward) {
    for (const auto& [extinction, scattering, g] :
         {std::array{0.0, 0.01, 0.0}, std::array{1.0, 0.6, -0.5}, std::array{0.02, 0.02, 0.9}}) {
        Numbers numbers;
        numbers.extinctionPerM = extinction;
        numbers.scatteringPerM = scattering;
        numbers.g = g;
        numbers.candela = 1e9;
        SCOPED_TRACE(extinction);
        expectEquation(drawn(written(numbers)), numbers);
    }
}

TEST_F(Comparable, narrowAndWideBeams) {
    Numbers numbers;
    numbers.halfAngleDeg = 60.0;
    expectEquation(drawn(written(numbers)), numbers);
    numbers.halfAngleDeg = 2.5;
    numbers.eyeTargetM = {0.25, 0.15, 2.9};
    numbers.fovDeg = 8.0;
    expectEquation(drawn(written(numbers)), numbers);
}

TEST_F(Comparable, lampsThatShineBackwards) {
    for (const double halfAngleDeg : {95.0, 120.0, 179.0}) {
        for (const double beamHalfAngleDeg : {0.0, 0.8 * halfAngleDeg}) {
            SCOPED_TRACE(fmt::format("{} degrees", halfAngleDeg));
            Numbers numbers;
            numbers.halfAngleDeg = halfAngleDeg;
            numbers.beamHalfAngleDeg = beamHalfAngleDeg;
            numbers.lensRadiusM = 0.05;
            numbers.lampTargetM = {-3.0, -5.0, 8.0};
            expectEquation(drawn(written(numbers)), numbers);
        }
    }
}

TEST_F(Comparable, colouredLightOnNeutralSurfaces) {
    Numbers numbers;
    numbers.color = {0.9, 0.5, 0.15};
    numbers.albedo = glm::dvec3(0.5);
    expectEquation(drawn(written(numbers)), numbers);
}

/// Open in the upper right quarter alone.
void writeQuarter(const std::filesystem::path& file) {
    constexpr std::size_t kSide = 32;
    render::ByteImage image{kSide, kSide, std::vector<std::uint8_t>(3 * kSide * kSide, 0)};
    for (std::size_t y = 0; y < kSide / 2; ++y) {
        const auto row = image.rgb.begin() + static_cast<std::ptrdiff_t>(3 * y * kSide);
        std::fill(row + 3 * kSide / 2, row + 3 * kSide, std::uint8_t{255});
    }
    render::writeImage(image, file);
}

/// Light on the floor in the four quarters around its middle, seen from above, where +X is right and +Y up.
std::string litQuarters(const render::FloatImage& image) {
    std::string lit;
    for (const bool up : {true, false}) {
        for (const bool right : {false, true}) {
            const float light = image.at(kWidth / 2 + (right ? 4 : -5), kHeight / 2 + (up ? -5 : 4))[0];
            if (light > 1.0f) lit += fmt::format("{} {}", up ? "upper" : "lower", right ? "right" : "left");
        }
    }
    return lit;
}

TEST_F(Comparable, theGoboLiesAsUpAndRotationSay) {
    writeQuarter(folder_.path() / "f.png");
    const auto quarter = [&](const char* keys) {
        return litQuarters(
            drawn(folder_
                      .write("a.toml",
                             fmt::format(
                                 "[haze]\nextinction=0\n"
                                 "[[camera]]\nname='c'\nposition=[0,-0.001,5]\ntarget=[0,0,0]\nfov=30\n"
                                 "[[light]]\nname='a'\nposition=[0,0,6]\ndirection=[0,0,-1]\nhalf_angle=10\n"
                                 "candela=1000\ngobo='f.png'\n{}\n[[object]]\ntype='floor'\n",
                                 keys))
                      .string()));
    };
    EXPECT_EQ(quarter(""), "upper right");
    EXPECT_EQ(quarter("up=[1,0,0]"), "lower right");
    EXPECT_EQ(quarter("up=[0,-1,0]"), "lower left");
    EXPECT_EQ(quarter("gobo_rotation=90"), "upper left");
}

// Exposure and bloom are what a screen needs; an EXR has neither.
TEST_F(Comparable, theExrKnowsNoScreen) {
    const std::string show = (showFolder() / "comparable.toml").string();
    const render::FloatImage plain = drawn(show);
    EXPECT_EQ(drawn(show, {"--ev", "14"}).rgb, plain.rgb);
    EXPECT_EQ(drawn(show, {"--no-bloom"}).rgb, plain.rgb);
}

// Peak intensity is what `candela` says and flux what `lumen` says, whatever the colour.
TEST_F(Comparable, lumensOfAFlatBeamFillItsSolidAngle) {
    Numbers numbers;
    const double solidAngleSr = 2.0 * kPi * (1.0 - std::cos(numbers.halfAngleDeg * kPi / 180.0));
    std::string show = showOf(numbers);
    show.replace(show.find("candela=10000"), 13, fmt::format("lumen={}", 10000.0 * solidAngleSr));
    expectEquation(drawn(folder_.write("a.toml", show).string()), numbers);
}

}  // namespace
}  // namespace hazer::app
