// A measured web on its grid, held against the functions that the files were made from.
#include "render/ies_web.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "render/error.h"
#include "render/web_formulas.h"
#include "tests/render/ies_text.h"

namespace hazer::test {
namespace {

using render::IesWeb;

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadPerDeg = kPi / 180.0;

IesWeb webOf(const IesText& file) {
    return render::parseIesWeb(file.text(), "test.ies");
}

/// A direction by its angle from the axis and around it: from +X towards +Y.
glm::dvec3 towards(double thetaDeg, double azimuthDeg) {
    const double theta = thetaDeg * kRadPerDeg;
    const double azimuth = azimuthDeg * kRadPerDeg;
    return {std::sin(theta) * std::cos(azimuth), std::sin(theta) * std::sin(azimuth), -std::cos(theta)};
}

double candelaAt(const IesWeb& web, const glm::dvec3& direction) {
    return web.peakCd * web.relativeAt(direction);
}

TEST(IesWeb, TheShadersKnowTheSizeOfThePicture) {
    const IesWeb web = webOf({});
    const render::glsl::WebFormulas<double> formulas{web};
    EXPECT_EQ(formulas.WEB_AZIMUTHS, render::kWebAzimuths);
    EXPECT_EQ(formulas.WEB_THETAS, render::kWebThetas);
    EXPECT_EQ(web.relative.size(), static_cast<std::size_t>(render::kWebAzimuths) * render::kWebThetas);
}

TEST(IesWeb, IsTheSameAllAroundForARoundBeam) {
    IesText file;
    file.verticalDeg = anglesFrom(0.0, 180.0, 37);
    file.candela = [](double, double v) { return 500.0 + 400.0 * std::cos(v * kRadPerDeg); };
    const IesWeb web = webOf(file);
    EXPECT_EQ(web.peakCd, 900.0);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> theta(0.0, 180.0);
    std::uniform_real_distribution<double> azimuth(-360.0, 360.0);
    for (int i = 0; i < 2000; ++i) {
        const double at = theta(random);
        // Linear between the file's 5 degrees: (5 deg)^2 / 8 of the curvature.
        EXPECT_NEAR(candelaAt(web, towards(at, azimuth(random))), file.candela(0.0, at), 0.5);
    }
    EXPECT_NEAR(candelaAt(web, {0.0, 0.0, -1.0}), 900.0, 1e-3);
    EXPECT_NEAR(candelaAt(web, {0.0, 0.0, 1.0}), 100.0, 1e-3);
}

TEST(IesWeb, EveryAzimuthOfAWholeCircleIsWhereItBelongs) {
    IesText file;
    file.verticalDeg = anglesFrom(0.0, 90.0, 46);
    file.horizontalDeg = anglesFrom(0.0, 360.0, 73);
    file.candela = [](double h, double v) {
        return 100.0 + 50.0 * std::sin(v * kRadPerDeg) *
                           (std::cos(h * kRadPerDeg) + 0.5 * std::sin(3.0 * h * kRadPerDeg));
    };
    const IesWeb web = webOf(file);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> theta(0.0, 89.0);
    std::uniform_real_distribution<double> azimuth(0.0, 360.0);
    for (int i = 0; i < 2000; ++i) {
        const double v = theta(random);
        const double h = azimuth(random);
        EXPECT_NEAR(candelaAt(web, towards(v, h)), file.candela(h, v), 0.35) << h << " " << v;
    }
    EXPECT_EQ(candelaAt(web, towards(100.0, 0.0)), 0.0);
}

TEST(IesWeb, SymmetriesOfTypeCFillTheCircle) {
    // A quarter is mirrored about both planes, a half about its ends, and the half 90..270 about +Y.
    const auto lobes = [](double h, double v) {
        return 100.0 + 90.0 * std::sin(v * kRadPerDeg) * std::cos(2.0 * h * kRadPerDeg);
    };
    IesText quarter;
    quarter.verticalDeg = anglesFrom(0.0, 90.0, 46);
    quarter.horizontalDeg = anglesFrom(0.0, 90.0, 19);
    quarter.candela = lobes;
    IesText half = quarter;
    half.horizontalDeg = anglesFrom(0.0, 180.0, 37);
    half.candela = [&](double h, double v) { return lobes(h, v) + 9.0 * std::cos(h * kRadPerDeg); };
    IesText side = quarter;
    side.horizontalDeg = anglesFrom(90.0, 270.0, 37);
    side.candela = [&](double h, double v) { return lobes(h, v) + 9.0 * std::sin(h * kRadPerDeg); };
    for (const IesText* file : {&quarter, &half, &side}) {
        const IesWeb web = webOf(*file);
        for (double h = 0.0; h < 360.0; h += 3.7) {
            EXPECT_NEAR(candelaAt(web, towards(60.0, h)), file->candela(h, 60.0), 0.4) << h;
        }
    }
}

/// Types A and B by the definition in ies_table.h, from the file's angles to a direction.
glm::dvec3 directionOf(int type, double hDeg, double vDeg) {
    const double h = hDeg * kRadPerDeg;
    const double v = vDeg * kRadPerDeg;
    if (type == 2) return {std::sin(h), std::cos(h) * std::sin(v), -std::cos(h) * std::cos(v)};
    return {std::cos(v) * std::sin(h), std::sin(v), -std::cos(v) * std::cos(h)};
}

TEST(IesWeb, TypesAAndBAreTurnedToTheAxis) {
    for (const int type : {2, 3}) {
        IesText file;
        file.type = type;
        file.verticalDeg = file.horizontalDeg = anglesFrom(-90.0, 90.0, 91);
        file.candela = [](double h, double v) {
            return 100.0 + 40.0 * std::sin(h * kRadPerDeg) +
                   30.0 * std::cos(h * kRadPerDeg) * std::sin(2.0 * v * kRadPerDeg);
        };
        const IesWeb web = webOf(file);
        std::mt19937 random(3);
        std::uniform_real_distribution<double> angle(-85.0, 85.0);
        for (int i = 0; i < 2000; ++i) {
            const double h = angle(random);
            const double v = angle(random);
            EXPECT_NEAR(candelaAt(web, directionOf(type, h, v)), file.candela(h, v), 0.6)
                << type << " " << h << " " << v;
        }
        EXPECT_EQ(candelaAt(web, {0.0, 0.1, 1.0}), 0.0);
    }
}

TEST(IesWeb, TypesAAndBThatBeginWithZeroAreMirrored) {
    for (const int type : {2, 3}) {
        IesText file;
        file.type = type;
        file.verticalDeg = anglesFrom(-45.0, 45.0, 46);
        file.horizontalDeg = anglesFrom(0.0, 45.0, 23);
        file.candela = [](double h, double v) { return 100.0 - h + 0.5 * v; };
        const IesWeb web = webOf(file);
        for (const double h : {-30.0, 30.0}) {
            EXPECT_NEAR(candelaAt(web, directionOf(type, h, 10.0)), 75.0, 0.1);
            EXPECT_NEAR(candelaAt(web, directionOf(type, h, -10.0)), 65.0, 0.1);
        }
    }
}

/// Integral over the sphere of a round beam that is linear between its angles, in closed form.
double fluxOfLinear(const std::vector<double>& degrees, const std::function<double(double)>& candela) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < degrees.size(); ++i) {
        const double a = degrees[i] * kRadPerDeg;
        const double b = degrees[i + 1] * kRadPerDeg;
        const double slope = (candela(degrees[i + 1]) - candela(degrees[i])) / (b - a);
        const double offset = candela(degrees[i]) - slope * a;
        // Of (offset + slope x) sin x: -(offset + slope x) cos x + slope sin x.
        const auto integral = [&](double x) {
            return -(offset + slope * x) * std::cos(x) + slope * std::sin(x);
        };
        sum += integral(b) - integral(a);
    }
    return 2.0 * kPi * sum;
}

TEST(IesWeb, FluxIsTheIntegralOverTheSphere) {
    IesText isotropic;
    isotropic.verticalDeg = {0.0, 180.0};
    EXPECT_NEAR(webOf(isotropic).fluxLm, 4.0 * kPi, 1e-4);
    const auto lobe = [](double v) { return 1000.0 * std::exp(-v * v / 300.0); };
    IesText file;
    file.verticalDeg = anglesFrom(0.0, 90.0, 37);
    file.candela = [&](double, double v) { return lobe(v); };
    EXPECT_NEAR(webOf(file).fluxLm / fluxOfLinear(file.verticalDeg, lobe), 1.0, 2e-4);
    // A floodlight of 1 cd over 60 x 60 degrees: 2 sin 30 deg x 60 deg. Its edges are a cell wide.
    file.type = 2;
    file.verticalDeg = file.horizontalDeg = anglesFrom(-30.0, 30.0, 5);
    file.candela = [](double, double) { return 1.0; };
    EXPECT_NEAR(webOf(file).fluxLm / (2.0 * 0.5 * kPi / 3.0), 1.0, 5e-3);
}

TEST(IesWeb, LumensOfTheFileScaleNothing) {
    IesText file;
    const std::string text = file.text();
    std::string relative = text;
    relative.replace(relative.find("1 -1 "), 5, "1 5000 ");
    EXPECT_EQ(render::parseIesWeb(relative, "relative.ies").fluxLm, webOf(file).fluxLm);
}

// 50 % at 1.5 degrees.
double narrowLobe(double degrees) {
    return 1e6 * std::exp2(-std::pow(degrees / 1.5, 4.0));
}

TEST(IesWeb, KeepsABeamOfThreeDegrees) {
    IesText file;
    file.verticalDeg = anglesFrom(0.0, 5.0, 101);
    file.candela = [](double, double v) { return narrowLobe(v); };
    const IesWeb web = webOf(file);
    EXPECT_EQ(web.peakCd, 1e6);
    for (double v = 0.0; v < 5.0; v += 0.013) {
        EXPECT_NEAR(candelaAt(web, towards(v, 77.0)), narrowLobe(v), 1.5e-3 * 1e6) << v;
    }
    EXPECT_NEAR(web.beamHalfAngleRad / kRadPerDeg, 1.5, 0.07);
    EXPECT_NEAR(web.fieldHalfAngleRad / kRadPerDeg, 1.5 * std::pow(std::log2(10.0), 0.25), 0.1);
    EXPECT_NEAR(web.cutHalfAngleRad / kRadPerDeg, 1.5 * std::pow(std::log2(1e5), 0.25), 0.12);
}

TEST(IesWeb, KeepsABeamOfThreeDegreesBesideTheAxis) {
    IesText file;
    file.type = 3;
    file.horizontalDeg = anglesFrom(24.0, 36.0, 121);
    file.verticalDeg = anglesFrom(-6.0, 6.0, 121);
    file.candela = [](double h, double v) { return narrowLobe(std::hypot((h - 30.0), v)); };
    const IesWeb web = webOf(file);
    for (double h = 25.0; h < 35.0; h += 0.17) {
        for (double v = -5.0; v < 5.0; v += 0.17) {
            EXPECT_NEAR(candelaAt(web, directionOf(3, h, v)), file.candela(h, v), 0.02 * 1e6)
                << h << " " << v;
        }
    }
}

TEST(IesWeb, TheCutIsWhereNextToNothingIsLeft) {
    IesText file;
    file.verticalDeg = {0.0, 10.0, 20.0, 30.0, 90.0};
    // Stray light of 1e-4 of the peak at 20 degrees counts, of 5e-6 from 30 on does not.
    file.candela = [](double, double v) { return v < 15.0 ? 1000.0 : v < 25.0 ? 0.1 : 0.005; };
    EXPECT_NEAR(webOf(file).cutHalfAngleRad / kRadPerDeg, 20.0 + 10.0 * 0.09 / 0.095, 0.6);
    IesText everywhere;
    everywhere.verticalDeg = {0.0, 180.0};
    EXPECT_NEAR(webOf(everywhere).cutHalfAngleRad, kPi, 1e-12);
}

TEST(IesWeb, RefusesAWebThatTheGridMisses) {
    IesText file;
    file.type = 3;
    file.horizontalDeg = {40.0, 40.0001};
    file.verticalDeg = {3.0, 3.0001};
    EXPECT_THROW(webOf(file), render::RenderError);
}

TEST(IesWeb, FloatAndDoubleAgree) {
    IesText file;
    file.verticalDeg = anglesFrom(0.0, 180.0, 37);
    file.horizontalDeg = anglesFrom(0.0, 360.0, 25);
    file.candela = [](double h, double v) {
        return 100.0 + 50.0 * std::sin(v * kRadPerDeg) * std::cos(h * kRadPerDeg);
    };
    const IesWeb web = webOf(file);
    std::mt19937 random(4);
    std::normal_distribution<double> component;
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 direction =
            glm::normalize(glm::dvec3(component(random), component(random), component(random)));
        const float inFloat = render::glsl::WebFormulas<float>{web}.webAt(glm::vec3(direction));
        EXPECT_NEAR(static_cast<double>(inFloat), web.relativeAt(direction), 2e-4);
    }
}

TEST(WebShape, TakesPeakAndAnglesFromTheWeb) {
    IesText file;
    file.verticalDeg = anglesFrom(0.0, 20.0, 101);
    file.candela = [](double, double v) { return 1e4 * std::exp2(-std::pow(v / 5.0, 2.0)); };
    const IesWeb web = webOf(file);
    render::Beam beam;
    beam.lensRadiusM = 0.1;
    render::BeamShape shape = render::webShape(beam, web);
    EXPECT_EQ(shape.peakCd, 1e4);
    EXPECT_EQ(shape.cutHalfAngleRad, web.cutHalfAngleRad);
    EXPECT_NEAR(shape.apexToLensM, 0.1 / std::tan(5.0 * std::sqrt(std::log2(10.0)) * kRadPerDeg), 0.01);
    beam.fluxLm = 3.0 * web.fluxLm;
    EXPECT_NEAR(render::webShape(beam, web).peakCd, 3e4, 1e-6);
    beam.intensityCd = 70.0;
    EXPECT_EQ(render::webShape(beam, web).peakCd, 70.0);
    IesText bulb;
    bulb.verticalDeg = {0.0, 180.0};
    EXPECT_EQ(render::webShape(beam, webOf(bulb)).apexToLensM, 0.0);
}

}  // namespace
}  // namespace hazer::test
