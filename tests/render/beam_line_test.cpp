// Thin beams drawn as lines: what a pixel's filter collects, against the oracle's rays under that filter.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "tests/render/beam_ways.h"

namespace hazer::test {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadPerDeg = kPi / 180.0;
constexpr double kRangeM = 1000.0;

/// A beam along -Z from the apex at the origin, and a camera; right, up and back are the camera's axes.
struct LineView {
    render::BeamShape shape;
    render::oracle::HazeModel haze;
    glm::dvec3 eyeM{0.0};
    glm::dmat3 cameraAxes{1.0};
    double pixel = 1e-3;  ///< A pixel's edge as a tangent.

    /// Through a place of the picture [tangent], 1 of depth.
    glm::dvec3 towards(const glm::dvec2& place) const { return cameraAxes * glm::dvec3(place, -1.0); }
    glm::dvec2 placeOf(const glm::dvec3& pointM) const {
        const glm::dvec3 seen = glm::transpose(cameraAxes) * (pointM - eyeM);
        return glm::dvec2(seen) / -seen.z;
    }
    double depthOf(const glm::dvec3& pointM) const { return glm::dot(eyeM - pointM, cameraAxes[2]); }
};

template <typename Scalar>
struct LineFormulas : render::glsl::Formulas<Scalar> {
    using Formulas = render::glsl::Formulas<Scalar>;
    using Vector = typename Formulas::Real3;

    explicit LineFormulas(const LineView& view)
        : optics{Scalar(std::cos(view.shape.cutHalfAngleRad)), Scalar(std::sin(view.shape.cutHalfAngleRad)),
                 Scalar(view.shape.apexToLensM), Scalar(view.shape.beamHalfAngleRad),
                 Scalar(view.shape.exponent)},
          haze{Scalar(view.haze.extinctionPerM), Scalar(view.haze.scatteringPerM), Scalar(view.haze.forwardG),
               Scalar(view.haze.backwardG), Scalar(view.haze.forwardWeight)},
          line(this->makeBeamLine(Vector(view.eyeM), Vector(view.cameraAxes[0]), Vector(view.cameraAxes[1]),
                                  Vector(view.cameraAxes[2]), Scalar(view.pixel), optics)) {}

    /// For a peak of 1 cd.
    double radiance(const LineView& view, const glm::dvec2& place, double endM = 1e5) {
        const Scalar ofFlux = this->lineRadiance(line, optics, haze, Vector(view.towards(place)),
                                                 Scalar(endM), Scalar(kRangeM));
        return static_cast<double>(ofFlux) * view.haze.scatteringPerM * render::profileSolidAngle(view.shape);
    }

    typename Formulas::BeamOptics optics;
    typename Formulas::HazeMedium haze;
    typename Formulas::BeamLine line;
};

double oracleRadiance(const LineView& view, const glm::dvec2& place) {
    return render::oracle::airRadiance(modelOf(view.shape), view.haze,
                                       {view.eyeM, glm::normalize(view.towards(place)), 1e5});
}

double gauss(double x) {
    const double sigma = render::glsl::Formulas<double>().LINE_DEVIATION;
    return std::exp(-0.5 * x * x / (sigma * sigma)) / (sigma * std::sqrt(2.0 * kPi));
}

/// The oracle under the filter of the pixel at `place`: rays over the stretch of the picture that holds the
/// beam, `radius` [tangent] to either side of its axis through `onAxis`, which runs along `along` (unit).
double filteredOracle(const LineView& view, const glm::dvec2& place, const glm::dvec2& onAxis,
                      const glm::dvec2& along, double radius) {
    constexpr int kAlong = 10;
    constexpr int kAcross = 64;
    constexpr double kReachPx = 2.2;
    const glm::dvec2 across(along.y, -along.x);
    double sum = 0.0;
    for (int i = 0; i < kAlong; ++i) {
        const double alongPx = kReachPx * (2.0 * (i + 0.5) / kAlong - 1.0);
        for (int k = 0; k < kAcross; ++k) {
            // Denser towards the edges, where a flat beam's chord ends in a root.
            const double angle = kPi * (k + 0.5) / kAcross;
            const double away = radius * std::cos(angle);
            const glm::dvec2 at = onAxis + along * (alongPx * view.pixel) + across * away;
            const glm::dvec2 off = (at - place) / view.pixel;
            sum += oracleRadiance(view, at) * gauss(glm::dot(off, across)) * gauss(glm::dot(off, along)) *
                   std::sin(angle) * kPi / kAcross * radius / view.pixel * 2.0 * kReachPx / kAlong;
        }
    }
    return sum;
}

/// A camera from anywhere that looks at a place of the axis, `axialM` from the apex, where the beam has a
/// radius of `radiusPx`.
LineView viewOf(std::mt19937& random, bool soft, double radiusPx, double& axialM) {
    const auto even = [&](double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(random);
    };
    render::Beam beam;
    beam.edge = soft ? render::BeamEdge::kSoft : render::BeamEdge::kFlat;
    const double halfDeg = std::exp(even(std::log(0.01), std::log(1.0)));
    beam.fieldAngleRad = 2.0 * halfDeg * kRadPerDeg;
    beam.beamAngleRad = even(0.3, 0.9) * beam.fieldAngleRad;
    beam.lensRadiusM = even(0.0, 1.0) < 0.5 ? 0.0 : 0.01;
    LineView view;
    view.shape = render::beamShape(beam);
    const double fromLensM = even(2.0, 10.0);
    axialM = view.shape.apexToLensM + fromLensM;
    const double beamRadiusM = axialM * std::tan(view.shape.cutHalfAngleRad);
    view.pixel = std::exp(even(std::log(5e-4), std::log(5e-3)));
    const double distanceM = beamRadiusM / (radiusPx * view.pixel);
    view.haze.extinctionPerM = even(0.0, 2.0) / (distanceM + fromLensM);
    view.haze.scatteringPerM = view.haze.extinctionPerM + 0.001;
    // Not along the beam: a whole pixel must look at it.
    const double aside = even(0.3, kPi - 0.3);
    const double around = even(0.0, 2.0 * kPi);
    const glm::dvec3 back(std::sin(aside) * std::cos(around), std::sin(aside) * std::sin(around),
                          std::cos(aside));
    view.eyeM = glm::dvec3(0.0, 0.0, -axialM) + distanceM * back;
    const glm::dvec3 tilted =
        glm::normalize(back + 0.3 * glm::dvec3(even(-1.0, 1.0), even(-1.0, 1.0), even(-1.0, 1.0)));
    const glm::dvec3 right =
        glm::normalize(glm::cross(glm::dvec3(even(-1.0, 1.0), even(-1.0, 1.0), even(-1.0, 1.0)), tilted));
    view.cameraAxes = glm::dmat3(right, glm::cross(tilted, right), tilted);
    return view;
}

struct Errors {
    std::vector<double> all;
    double at(double share) {
        std::sort(all.begin(), all.end());
        return all[static_cast<std::size_t>(share * static_cast<double>(all.size() - 1))];
    }
};

template <typename Scalar>
Errors errorsOf(int count, bool soft, double fromPx, double toPx) {
    std::mt19937 random(5);
    Errors errors;
    for (int i = 0; i < count; ++i) {
        double axialM = 0.0;
        const double radiusPx =
            std::exp(std::uniform_real_distribution<double>(std::log(fromPx), std::log(toPx))(random));
        const LineView view = viewOf(random, soft, radiusPx, axialM);
        const glm::dvec3 pointM(0.0, 0.0, -axialM);
        const glm::dvec2 onAxis = view.placeOf(pointM);
        // Does the beam reach beyond the filter on both sides?
        const glm::dvec2 step = view.placeOf(pointM - glm::dvec3(0.0, 0.0, 1e-3)) - onAxis;
        const glm::dvec2 lens = view.placeOf({0.0, 0.0, -view.shape.apexToLensM});
        if (glm::distance(lens, onAxis) < 6.0 * view.pixel) continue;
        const glm::dvec2 along = glm::normalize(step);
        const double away = std::uniform_real_distribution<double>(-1.2, 1.2)(random) * view.pixel;
        const glm::dvec2 place = onAxis + away * glm::dvec2(along.y, -along.x);
        const double expected = filteredOracle(view, place, onAxis, along, 1.6 * radiusPx * view.pixel);
        const double got = LineFormulas<Scalar>(view).radiance(view, place);
        EXPECT_TRUE(std::isfinite(got));
        errors.all.push_back(std::abs(got / expected - 1.0));
    }
    return errors;
}

TEST(BeamLine, HoldsWhatTheFilterCollects) {
    for (const bool soft : {false, true}) {
        Errors thin = errorsOf<float>(24, soft, 0.003, 0.3);
        Errors wider = errorsOf<float>(24, soft, 0.3, 1.5);
        fmt::print("{}: radius below 0.3 px: median {:.1e}, worst {:.1e} of {}; to 1.5 px: {:.1e}, {:.1e}\n",
                   soft ? "soft" : "flat", thin.at(0.5), thin.at(1.0), thin.all.size(), wider.at(0.5),
                   wider.at(1.0));
        EXPECT_GT(thin.all.size(), 8u);
        EXPECT_LT(thin.at(0.5), 3e-3);
        EXPECT_LT(thin.at(1.0), 2e-2);
        EXPECT_LT(wider.at(0.5), 1e-2);
        EXPECT_LT(wider.at(1.0), 5e-2);
    }
}

TEST(BeamLine, FloatIsAsGoodAsDouble) {
    std::mt19937 random(6);
    double worst = 0.0;
    for (int i = 0; i < 2000; ++i) {
        double axialM = 0.0;
        const LineView view = viewOf(random, i % 2 == 0, 0.2, axialM);
        const glm::dvec2 place = view.placeOf({0.0, 0.0, -axialM}) + glm::dvec2(0.3, -0.2) * view.pixel;
        const double inDouble = LineFormulas<double>(view).radiance(view, place);
        const double inFloat = LineFormulas<float>(view).radiance(view, place);
        if (inDouble > 0.0) worst = std::max(worst, std::abs(inFloat / inDouble - 1.0));
    }
    fmt::print("float over double: worst {:.1e}\n", worst);
    EXPECT_LT(worst, 5e-3);
}

/// A flat beam without a lens, seen by a camera at `eyeM`.
LineView plainView(const glm::dvec3& eyeM, const glm::dvec3& targetM, double halfAngleDeg = 0.1) {
    render::Beam beam;
    beam.edge = render::BeamEdge::kFlat;
    beam.fieldAngleRad = 2.0 * halfAngleDeg * kRadPerDeg;
    beam.beamAngleRad = beam.fieldAngleRad;
    beam.lensRadiusM = 0.0;
    LineView view;
    view.shape = render::beamShape(beam);
    view.haze = {0.0, 0.02, 0.0, 0.0, 1.0};
    view.eyeM = eyeM;
    const glm::dvec3 back = glm::normalize(eyeM - targetM);
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0.2, 0.9, 0.1), back));
    view.cameraAxes = glm::dmat3(right, glm::cross(back, right), back);
    return view;
}

/// Where the grid's middle pixel lies [px].
constexpr glm::dvec2 kGridOff(0.37, -0.21);

/// Sum over a grid of pixels of the line's radiance times a pixel's solid angle in the middle [sr].
double gridSum(const LineView& view, int halfPixels) {
    LineFormulas<float> formulas(view);
    double sum = 0.0;
    for (int y = -halfPixels; y <= halfPixels; ++y) {
        for (int x = -halfPixels; x <= halfPixels; ++x)
            sum += formulas.radiance(view, (glm::dvec2(x, y) + kGridOff) * view.pixel);
    }
    return sum * view.pixel * view.pixel;
}

// Seen end-on, a beam is a dot. In clear isotropic haze the light of a line of flux F from D0 on, all of it
// in line with the eye, is sigma F / (4 pi) times the integral of ds / (D0 + s)^2, which is 1 / D0.
TEST(BeamLine, SeenFromBehindItIsADotOfTheSameLight) {
    for (const double asideM : {0.0, 1e-6, 1e-3, 0.02}) {
        LineView view = plainView({asideM, 0.0, 40.0}, {0.0, 0.0, 0.0});
        // So coarse that the opening is within a pixel.
        view.pixel = 0.01;
        const double flux = render::profileSolidAngle(view.shape);
        const double expected = view.haze.scatteringPerM * flux / (4.0 * kPi) * (1.0 / 40.0 - 1.0 / 1040.0);
        EXPECT_NEAR(gridSum(view, 6) / expected, 1.0, 1e-2) << asideM;
    }
}

// Pointed past the camera it stretches over much of the picture; the same integral, of ds / D^2, is an angle
// over the distance between eye and axis (Kulla and Fajardo 2012), here over the picture's cosines.
TEST(BeamLine, PointedPastTheEyeItKeepsItsLight) {
    for (const double asideM : {1.0, 2.0, 5.0}) {
        LineView view = plainView({asideM, 0.0, -60.0}, {0.0, 0.0, 0.0}, 0.005);
        view.pixel = 0.002;
        const double flux = render::profileSolidAngle(view.shape);
        double expected = 0.0;
        constexpr int kSteps = 200000;
        const double nearM = 0.5 * asideM;
        const double ratio = std::pow(60.0 / nearM, 1.0 / kSteps);
        for (int i = 0; i < kSteps; ++i) {
            const double alongM = nearM * std::pow(ratio, i + 0.5);
            const glm::dvec3 pointM(0.0, 0.0, -60.0 + alongM);
            const glm::dvec2 fromMiddle = glm::abs(view.placeOf(pointM) / view.pixel - kGridOff);
            if (std::max(fromMiddle.x, fromMiddle.y) > 120.5) continue;
            const double depthM = view.depthOf(pointM);
            const double awayM = glm::distance(view.eyeM, pointM);
            // A pixel's solid angle is the cosine cubed of that in the middle.
            expected += alongM * std::log(ratio) * awayM / (depthM * depthM * depthM);
        }
        expected *= view.haze.scatteringPerM * flux / (4.0 * kPi);
        EXPECT_NEAR(gridSum(view, 120) / expected, 1.0, 2e-2) << asideM;
    }
}

TEST(BeamLine, RaysAndLinesShareEveryPlace) {
    const LineView view = plainView({3.0, 0.0, -5.0}, {0.0, 0.0, -5.0});
    LineFormulas<double> formulas(view);
    double before = 0.0;
    for (double axialM = 0.1; axialM < 100.0; axialM *= 1.02) {
        const double share = formulas.rayShare(formulas.line, axialM, 3.0);
        EXPECT_GE(share, before);
        EXPECT_LE(share, 1.0);
        const double radiusPx = axialM * std::tan(view.shape.cutHalfAngleRad) / (3.0 * view.pixel);
        EXPECT_TRUE(radiusPx > 1.9 || share == 0.0);
        EXPECT_TRUE(radiusPx < 4.1 || share == 1.0);
        before = share;
    }
}

TEST(BeamLine, EndsAtWhatThePixelSees) {
    const LineView view = plainView({3.0, 0.0, -5.0}, {0.0, 0.0, -5.0});
    LineFormulas<float> formulas(view);
    const double whole = formulas.radiance(view, {0.0, 0.0});
    EXPECT_GT(whole, 0.0);
    EXPECT_EQ(formulas.radiance(view, {0.0, 0.0}, 2.9), 0.0);
    EXPECT_NEAR(formulas.radiance(view, {0.0, 0.0}, 3.1), whole, 1e-4 * whole);
}

TEST(BeamLine, ExtremesStayNumbers) {
    std::mt19937 random(8);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 20000; ++i) {
        const double far = std::pow(10.0, 6.0 * std::uniform_real_distribution<double>(-1.0, 1.0)(random));
        LineView view = plainView(far * glm::dvec3(normal(random), normal(random), normal(random)),
                                  {normal(random), normal(random), normal(random)});
        if (i % 4 == 0) view.eyeM.x = view.eyeM.y = 0.0;
        if (i % 8 == 0) view.cameraAxes = glm::dmat3(1.0);
        view.haze = {0.05, 0.05, 0.9, -0.5, 0.9};
        LineFormulas<float> formulas(view);
        const double got = formulas.radiance(view, {0.3 * normal(random), 0.3 * normal(random)});
        ASSERT_TRUE(std::isfinite(got) && got >= 0.0) << i;
    }
}

}  // namespace
}  // namespace hazer::test
