// The table of line integrals through gobos, against direct integrals of the same pictures.
#include "render/gobo_table.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/render/gobo_pictures.h"
#include "tests/render/gobo_table_view.h"

namespace hazer::test {
namespace {

using render::buildGoboTable;
using render::GoboPicture;
using render::GoboTable;
using View = GoboTableView<float>;

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadPerDeg = kPi / 180.0;

GoboLamp flatLamp(double fieldHalfAngleDeg) {
    GoboLamp lamp;
    lamp.fieldHalfAngleRad = fieldHalfAngleDeg * kRadPerDeg;
    lamp.beamHalfAngleRad = lamp.fieldHalfAngleRad;
    return lamp;
}

/// 50 % at `beamOverField` of the field angle, 10 % at the field angle.
GoboLamp softLamp(double fieldHalfAngleDeg, double beamOverField) {
    GoboLamp lamp = flatLamp(fieldHalfAngleDeg);
    lamp.beamHalfAngleRad *= beamOverField;
    lamp.exponent = std::min(std::log(std::log(10.0) / std::log(2.0)) / -std::log(beamOverField), 12.0);
    lamp.reach = 1.125;
    return lamp;
}

struct Ray {
    GoboLamp lamp;
    GoboHaze haze;
    glm::dvec3 eye{0.0};
    glm::dvec3 direction{0.0};
};

/// Looks at a random point of the beam from anywhere outside it.
Ray randomRay(const GoboLamp& lamp, std::mt19937& random) {
    const auto between = [&](double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(random);
    };
    std::normal_distribution<double> normal;
    Ray ray;
    ray.lamp = lamp;
    ray.lamp.turnRad = between(0.0, 2.0 * kPi);
    ray.haze.forwardG = between(0.6, 0.78);
    const double psi = lamp.fieldHalfAngleRad * std::sqrt(between(0.0, 1.0));
    const double around = between(0.0, 2.0 * kPi);
    const glm::dvec3 target =
        between(2.0, 20.0) *
        glm::dvec3(std::sin(psi) * std::cos(around), std::sin(psi) * std::sin(around), -std::cos(psi));
    ray.direction = glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
    ray.eye = target - between(5.0, 40.0) * ray.direction;
    return ray;
}

/// Rays that are lit along the whole of their chord.
struct Rays {
    Rays(const GoboLamp& lamp, std::size_t count) {
        std::mt19937 random(7);
        while (direct.size() < count) {
            const Ray ray = randomRay(lamp, random);
            GoboRay crossing(ray.lamp, ray.haze, ray.eye, ray.direction, 1024);
            if (!crossing.isCrossing()) continue;
            const View view(ray.lamp, ray.haze, ray.eye, ray.direction);
            if (!view.isCrossing) continue;
            direct.push_back(std::move(crossing));
            views.push_back(view);
        }
    }
    std::vector<GoboRay> direct;
    std::vector<View> views;
};

/// How far the table is from a picture: rms over the rays of the error over the same ray without gobo.
double errorOf(Rays& rays, const GoboTable& table, double blurLevel, const std::vector<std::uint8_t>& rgba,
               int channel = 0) {
    double squares = 0.0;
    for (std::size_t i = 0; i < rays.direct.size(); ++i) {
        const double error =
            rays.views[i].through(table, blurLevel)[channel] - rays.direct[i].through(rgba, channel);
        squares += std::pow(error / rays.direct[i].withoutGobo(), 2);
    }
    return std::sqrt(squares / static_cast<double>(rays.direct.size()));
}

constexpr double kMaxError = 0.004;

void expectClose(Rays& rays, const GoboLamp& lamp, const NamedGobo& gobo) {
    const GoboTable table = buildGoboTable(gobo.picture, goboProfile(lamp));
    const double error = errorOf(rays, table, 0.0, gobo.picture.levels[0]);
    fmt::print(" {} {:.2f} %", gobo.name, 100.0 * error);
    EXPECT_LT(error, kMaxError) << gobo.name;
}

TEST(GoboTable, FollowsDirectIntegralsOfTheLibrarysGobos) {
    const GoboLamp lamp = flatLamp(12.0);
    Rays rays(lamp, 2000);
    for (const NamedGobo& gobo : libraryGobos()) expectClose(rays, lamp, gobo);
    fmt::print("\n");
}

TEST(GoboTable, FollowsDirectIntegralsInFlatAndSoftBeams) {
    for (const GoboLamp& lamp :
         {flatLamp(0.3), flatLamp(25.0), softLamp(12.0, 0.5), softLamp(12.0, 0.8), softLamp(25.0, 0.9)}) {
        fmt::print("field {:.1f} degrees, exponent {:.1f}:", 2.0 * lamp.fieldHalfAngleRad / kRadPerDeg,
                   lamp.exponent);
        Rays rays(lamp, 400);
        for (const NamedGobo& gobo : drawnGobos()) expectClose(rays, lamp, gobo);
        fmt::print("\n");
    }
}

// Each level is the mip level of the picture, so that taps and tables meet without a seam.
TEST(GoboTable, BlurLevelsAreThoseOfThePicture) {
    const GoboLamp lamp = softLamp(12.0, 0.9);
    Rays rays(lamp, 500);
    for (const NamedGobo& gobo : drawnGobos()) {
        const GoboTable table = buildGoboTable(gobo.picture, goboProfile(lamp));
        fmt::print("{:>14}:", gobo.name);
        for (std::size_t level = 0; level < render::kGoboLevels; ++level) {
            const double error = errorOf(rays, table, static_cast<double>(level), gobo.picture.levels[level]);
            fmt::print(" {:.2f}", 100.0 * error);
            EXPECT_LT(error, kMaxError) << gobo.name << ", level " << level;
        }
        fmt::print(" %\n");
    }
}

/// The picture behind a disc: every texel the mean of all within `radius` texels.
std::vector<std::uint8_t> blurredByDisc(const std::vector<std::uint8_t>& rgba, int radius) {
    constexpr int kSize = render::kGoboSize;
    // Sums along rows make the discs cheap.
    std::vector<double> sums((kSize + 1) * kSize, 0.0);
    for (std::size_t i = 0; i < std::size_t{kSize} * kSize; ++i) {
        const std::size_t row = i / kSize;
        sums[i + row + 1] = sums[i + row] + rgba[4 * i];
    }
    std::vector<std::uint8_t> result(rgba.size(), 255);
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            double sum = 0.0;
            int count = 0;
            for (int dy = -radius; dy <= radius; ++dy) {
                const int half = static_cast<int>(std::sqrt(radius * radius - dy * dy));
                count += 2 * half + 1;
                if (y + dy < 0 || y + dy >= kSize) continue;
                const auto at = [&](int column) {
                    return sums[static_cast<std::size_t>((y + dy) * (kSize + 1) +
                                                         std::clamp(column, 0, kSize))];
                };
                sum += at(x + half + 1) - at(x - half);
            }
            const auto value = static_cast<std::uint8_t>(std::lround(sum / count));
            for (int c = 0; c < 3; ++c) result[static_cast<std::size_t>(4 * (y * kSize + x) + c)] = value;
        }
    }
    return result;
}

TEST(GoboTable, LevelLBlursAsADiscOf2ToTheLTexelsRadius) {
    const GoboLamp lamp = softLamp(12.0, 0.9);
    Rays rays(lamp, 400);
    for (const NamedGobo& gobo : drawnGobos()) {
        // Not what repeats every few texels: there a disc turns bright into dark, and texels do not. Nor what
        // is nothing but its rim, where the picture ends.
        if (gobo.name != "letter" && gobo.name != "noise") continue;
        const GoboTable table = buildGoboTable(gobo.picture, goboProfile(lamp));
        for (const int level : {2, 5}) {
            const auto blurred = blurredByDisc(gobo.picture.levels[0], 1 << level);
            const double same = errorOf(rays, table, level, blurred);
            const double less = errorOf(rays, table, level - 1, blurred);
            const double more = errorOf(rays, table, level + 1, blurred);
            fmt::print("{:>14}, disc of {:2} texels: {:.2f} %; a level less {:.2f} %, more {:.2f} %\n",
                       gobo.name, 1 << level, 100.0 * same, 100.0 * less, 100.0 * more);
            EXPECT_LT(same, 0.02);
            EXPECT_LT(same, 0.5 * less);
            EXPECT_LT(same, 0.5 * more);
        }
    }
}

// A white gobo leaves the chord of the beam's own profile.
TEST(GoboTable, AWhiteGoboIsTheChordOfTheProfile) {
    for (const GoboLamp& lamp : {flatLamp(12.0), softLamp(12.0, 0.8), softLamp(12.0, 0.95)}) {
        const GoboTable table = buildGoboTable(whiteGobo(), goboProfile(lamp));
        render::glsl::GoboTableFormulas<double> formulas{&table};
        const double radius = formulas.goboTableRadius(lamp.exponent);
        for (const double turn : {0.0, 0.125, 0.3, 0.77}) {
            for (const double distance : {0.0, 0.3, 0.6, 0.8}) {
                const double halfChord = std::sqrt(1.0 - distance * distance);
                glm::dvec4 expected(0.0);
                constexpr int kSteps = 4000;
                for (int i = 0; i < kSteps; ++i) {
                    const double xi = 2.0 * (i + 0.5) / kSteps - 1.0;
                    const double q = radius * std::hypot(distance, halfChord * xi);
                    // The holder begins two texels' width inside the field's edge.
                    if (q > 1.0 - 2.0 / render::kGoboSize) continue;
                    const double profile =
                        lamp.exponent == 0.0
                            ? 1.0
                            : (std::pow(0.5, std::pow(q / (lamp.beamHalfAngleRad / lamp.fieldHalfAngleRad),
                                                      lamp.exponent)) -
                               0.005) /
                                  0.995;
                    expected += 2.0 / kSteps * profile *
                                glm::dvec4(1.0, xi, 1.5 * xi * xi - 0.5, 2.5 * xi * xi * xi - 1.5 * xi);
                }
                const glm::dvec4 moments = formulas.goboMoments({turn, distance, {}, 0.0}, 0.0, 0);
                for (int k = 0; k < 4; ++k) {
                    EXPECT_NEAR(moments[k], expected[k], 0.01)
                        << "moment " << k << ", distance " << distance << ", exponent " << lamp.exponent;
                }
            }
        }
    }
}

/// Turned counter-clockwise by a quarter.
GoboPicture turnedByAQuarter(const GoboPicture& picture) {
    GoboPicture turned = picture;
    for (int level = 0; level < render::kGoboLevels; ++level) {
        const int size = render::kGoboSize >> level;
        const auto& from = picture.levels[static_cast<std::size_t>(level)];
        auto& to = turned.levels[static_cast<std::size_t>(level)];
        for (int row = 0; row < size; ++row) {
            for (int column = 0; column < size; ++column) {
                // What was on top at this height is now as far from the left.
                const int source = 4 * (column * size + size - 1 - row);
                std::copy_n(from.begin() + source, 4, to.begin() + 4 * (row * size + column));
            }
        }
    }
    return turned;
}

TEST(GoboTable, AQuarterTurnShiftsTheTable) {
    const render::GoboProfile profile = goboProfile(softLamp(12.0, 0.8));
    const GoboTable table = buildGoboTable(letterGobo(), profile);
    const GoboTable turned = buildGoboTable(turnedByAQuarter(letterGobo()), profile);
    render::glsl::GoboTableFormulas<float> before{&table};
    render::glsl::GoboTableFormulas<float> after{&turned};
    for (int level = 0; level < before.GOBO_TABLE_LEVELS; ++level) {
        const glm::vec4 place = before.goboTableLevel(level);
        const int columns = static_cast<int>(place.z);
        for (int row = 0; row < static_cast<int>(place.w); ++row) {
            for (int column = 0; column < columns; ++column) {
                const glm::vec2 from(place.x + static_cast<float>(column) + 0.5f,
                                     place.y + static_cast<float>(row) + 0.5f);
                const glm::vec2 to(place.x + static_cast<float>((column + columns / 4) % columns) + 0.5f,
                                   from.y);
                const glm::vec4 difference =
                    before.goboTableTexel(from, 0.0f) - after.goboTableTexel(to, 0.0f);
                // A step of a 16-bit float.
                for (int k = 0; k < 4; ++k)
                    ASSERT_NEAR(difference[k], 0.0f, 1.0f / 1024.0f) << "level " << level << ", row " << row;
            }
        }
    }
}

TEST(GoboTable, TurningTheLampsGoboTurnsTheLine) {
    const GoboTable table = buildGoboTable(letterGobo(), goboProfile(flatLamp(12.0)));
    const GoboTable turned = buildGoboTable(turnedByAQuarter(letterGobo()), goboProfile(flatLamp(12.0)));
    std::mt19937 random(5);
    for (int i = 0; i < 200; ++i) {
        Ray ray = randomRay(flatLamp(12.0), random);
        ray.lamp.turnRad = 0.0;
        View withTurnedPicture(ray.lamp, ray.haze, ray.eye, ray.direction);
        ray.lamp.turnRad = 0.5 * kPi;
        View withTurnedLamp(ray.lamp, ray.haze, ray.eye, ray.direction);
        const double expected = withTurnedPicture.through(turned, 0.0).x;
        EXPECT_NEAR(withTurnedLamp.through(table, 0.0).x, expected, 2e-3 * expected + 1e-9);
    }
}

// Light in even haze that scatters evenly is the same from both ends of a ray.
TEST(GoboTable, IsTheSameSeenFromBothSides) {
    const GoboTable table = buildGoboTable(letterGobo(), goboProfile(flatLamp(12.0)));
    std::mt19937 random(6);
    const GoboHaze haze{0.0, 0.0};
    int lit = 0;
    for (int i = 0; i < 500; ++i) {
        const Ray ray = randomRay(flatLamp(12.0), random);
        View there(ray.lamp, haze, ray.eye, ray.direction);
        View back(ray.lamp, haze, ray.eye + 100.0 * ray.direction, -ray.direction);
        const double expected = there.through(table, 0.0).x;
        lit += expected > 0.0 ? 1 : 0;
        EXPECT_NEAR(back.through(table, 0.0).x, expected, 1e-3 * expected + 1e-7);
    }
    EXPECT_GT(lit, 200);
}

// A gobo that is open on its right half only: along +X, the open half is the one towards xi = 1.
TEST(GoboTable, OddMomentsSayWhichHalfIsOpen) {
    const GoboTable table =
        buildGoboTable(drawnGobo([](double x, double) { return x > 0.0; }), goboProfile(flatLamp(12.0)));
    render::glsl::GoboTableFormulas<double> formulas{&table};
    // A line's direction is its normal turned by a quarter counter-clockwise: +X for a normal along -Y.
    const glm::dvec4 rightwards = formulas.goboMoments({0.75, 0.0, {}, 0.0}, 0.0, 0);
    const glm::dvec4 leftwards = formulas.goboMoments({0.25, 0.0, {}, 0.0}, 0.0, 0);
    // Integrals of P_0..P_3 over 0..1; the holder takes some thousandths.
    const glm::dvec4 expected(1.0, 0.5, 0.0, -0.125);
    for (int k = 0; k < 4; ++k) {
        EXPECT_NEAR(rightwards[k], expected[k], 0.006);
        EXPECT_NEAR(leftwards[k], k % 2 == 0 ? expected[k] : -expected[k], 0.006);
    }
    // Off the middle: the line above it along +X, and the one to the right of it, upwards.
    EXPECT_NEAR(formulas.goboMoments({0.25, 0.5, {}, 0.0}, 0.0, 0).y, -0.5, 0.006);
    EXPECT_NEAR(formulas.goboMoments({0.0, 0.5, {}, 0.0}, 0.0, 0).x, 2.0, 0.012);
    EXPECT_NEAR(formulas.goboMoments({0.5, 0.5, {}, 0.0}, 0.0, 0).x, 0.0, 0.01);
}

TEST(GoboTable, AColouredGoboHasALayerForEachColour) {
    const std::vector<NamedGobo> drawn = drawnGobos();
    GoboPicture mixed = drawn[0].picture;
    EXPECT_TRUE(mixed.grey);
    for (std::size_t level = 0; level < render::kGoboLevels; ++level) {
        for (std::size_t i = 0; i < mixed.levels[level].size(); i += 4) {
            mixed.levels[level][i + 1] = drawn[1].picture.levels[level][i];
            mixed.levels[level][i + 2] = drawn[2].picture.levels[level][i];
        }
    }
    mixed.grey = false;
    const render::GoboProfile profile = goboProfile(flatLamp(12.0));
    const GoboTable table = buildGoboTable(mixed, profile);
    ASSERT_EQ(table.layers, 3);
    for (std::size_t c = 0; c < 3; ++c) {
        const GoboTable one = buildGoboTable(drawn[c].picture, profile);
        ASSERT_EQ(one.layers, 1);
        EXPECT_TRUE(std::equal(one.halves.begin(), one.halves.end(),
                               table.halves.begin() + static_cast<std::ptrdiff_t>(c * one.halves.size())));
    }
    Rays rays(flatLamp(12.0), 300);
    for (int c = 0; c < 3; ++c) EXPECT_LT(errorOf(rays, table, 0.0, mixed.levels[0], c), kMaxError);
}

// A blur that grows from left to right over the gobo by a mip level: to the texture unit each place is a mix
// of two levels.
TEST(GoboTable, TheBlurMayChangeAlongALine) {
    const GoboLamp lamp = softLamp(12.0, 0.9);
    Rays rays(lamp, 150);
    const auto shareOfBlurrier = [](const glm::dvec2& q) { return 0.5 + 0.4 * q.x; };
    for (const NamedGobo& gobo : drawnGobos()) {
        const GoboTable table = buildGoboTable(gobo.picture, goboProfile(lamp));
        double squares = 0.0;
        for (std::size_t i = 0; i < rays.direct.size(); ++i) {
            View& view = rays.views[i];
            const GoboRay& direct = rays.direct[i];
            const double turn = 2.0 * kPi * view.line.turn;
            const double radius =
                static_cast<double>(view.goboTableRadius(static_cast<float>(lamp.exponent)));
            const double halfChord = radius * std::sqrt(1.0 - view.line.distance * view.line.distance);
            const double level = 3.0 + shareOfBlurrier({radius * view.line.distance * std::cos(turn), 0.0});
            const double drawn = view.through(table, level, -0.4 * halfChord * std::sin(turn)).x;
            const double expected = direct.through(gobo.picture.levels[3], 0, [&](const glm::dvec2& q) {
                return 1.0 - shareOfBlurrier(q);
            }) + direct.through(gobo.picture.levels[4], 0, shareOfBlurrier);
            squares += std::pow((drawn - expected) / direct.withoutGobo(), 2);
        }
        const double error = std::sqrt(squares / static_cast<double>(rays.direct.size()));
        fmt::print(" {} {:.2f} %", gobo.name, 100.0 * error);
        EXPECT_LT(error, kMaxError) << gobo.name;
    }
    fmt::print("\n");
}

TEST(GoboTable, BetweenLevelsItIsInBetween) {
    const GoboTable table = buildGoboTable(letterGobo(), goboProfile(flatLamp(12.0)));
    std::mt19937 random(8);
    for (int i = 0; i < 100; ++i) {
        const Ray ray = randomRay(flatLamp(12.0), random);
        View view(ray.lamp, ray.haze, ray.eye, ray.direction);
        const double sharp = view.through(table, 2.0).x;
        const double blurred = view.through(table, 3.0).x;
        EXPECT_NEAR(view.through(table, 2.25).x, 0.75 * sharp + 0.25 * blurred,
                    1e-5 * (sharp + blurred) + 1e-12);
        EXPECT_EQ(view.through(table, 9.0), view.through(table, 7.0));
    }
}

TEST(GoboTable, ItsChordIsTheStretchWithinItsDisc) {
    std::mt19937 random(9);
    int crossing = 0;
    for (int i = 0; i < 2000; ++i) {
        const Ray ray = randomRay(i % 2 == 0 ? flatLamp(12.0) : softLamp(12.0, 0.8), random);
        const GoboRay direct(ray.lamp, ray.haze, ray.eye, ray.direction, 1);
        if (!direct.isCrossing()) continue;
        GoboTableView<double> view(ray.lamp, ray.haze, ray.eye, ray.direction);
        ASSERT_TRUE(view.isCrossing);
        double from = 0.0, to = 0.0;
        ASSERT_TRUE(view.goboLineStretch(view.ray, view.line, from, to));
        EXPECT_NEAR(from + view.ray.tClosest, direct.fromM(), 1e-9 * direct.toM());
        EXPECT_NEAR(to + view.ray.tClosest, direct.toM(), 1e-9 * direct.toM());
        ++crossing;
    }
    EXPECT_GT(crossing, 500);
}

TEST(GoboTable, HasNoChordForARayThatRunsAlongTheBeam) {
    // In the beam, and away from the lamp: the far end of the chord is nowhere.
    GoboTableView<double> view(flatLamp(12.0), {}, {0.1, 0.0, -5.0}, {0.0, 0.05, -1.0});
    ASSERT_TRUE(view.isCrossing);
    double from = 0.0, to = 0.0;
    EXPECT_FALSE(view.goboLineStretch(view.ray, view.line, from, to));
}

// Rays through the apex, on the axis, across it, far off and of beams of every width: numbers all the same.
TEST(GoboTable, ExtremeRaysStayFinite) {
    std::mt19937 random(10);
    const auto between = [&](double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(random);
    };
    const GoboTable table = buildGoboTable(letterGobo(), goboProfile(softLamp(12.0, 0.8)));
    for (int i = 0; i < 100000; ++i) {
        const GoboLamp lamp = softLamp(std::pow(10.0, between(-2.0, 1.94)), 0.8);
        const double far = std::pow(10.0, between(-3.0, 5.0));
        glm::dvec3 eye = far * glm::dvec3(between(-1.0, 1.0), between(-1.0, 1.0), between(-1.0, 1.0));
        glm::dvec3 direction(between(-1.0, 1.0), between(-1.0, 1.0), between(-1.0, 1.0));
        if (i % 5 == 1) eye = glm::dvec3(0.0, 0.0, eye.z);
        if (i % 5 == 2) eye = glm::dvec3(0.0);
        if (i % 5 == 3) direction = -eye;
        if (i % 5 == 4) direction = glm::dvec3(0.0, 0.0, i % 2 == 0 ? 1.0 : -1.0);
        View view(lamp, {}, eye, direction);
        if (!view.isCrossing) continue;
        ASSERT_TRUE(view.line.turn >= 0.0f && view.line.turn <= 1.0f) << i;
        ASSERT_TRUE(view.line.distance >= 0.0f && view.line.distance < 1.0f) << i;
        float from = 0.0f, to = 0.0f;
        if (!view.goboLineStretch(view.ray, view.line, from, to)) continue;
        ASSERT_TRUE(std::isfinite(from) && std::isfinite(to)) << i;
        ASSERT_TRUE(std::isfinite(view.through(table, 1.5).x)) << i;
    }
}

TEST(GoboTable, CoefficientsAreExactForCubics) {
    render::glsl::GoboTableFormulas<double> formulas;
    const auto cubic = [](double x) { return 0.3 - 1.1 * x + 0.7 * x * x + 2.3 * x * x * x; };
    // By hand: x^2 = (1 + 2 P_2) / 3, x^3 = (3 P_1 + 2 P_3) / 5.
    const glm::dvec4 expected(0.3 + 0.7 / 3.0, -1.1 + 2.3 * 0.6, 0.7 * 2.0 / 3.0, 2.3 * 0.4);
    for (const double spread : {1.0, 0.8}) {
        glm::dvec4 values;
        for (int i = 0; i < 4; ++i) values[i] = cubic(formulas.goboNode(i, spread));
        const glm::dvec4 coefficients = formulas.goboCoefficients(values, spread);
        for (int k = 0; k < 4; ++k) EXPECT_NEAR(coefficients[k], expected[k], 1e-12);
    }
}

TEST(GoboTable, HasTheShadersSize) {
    const render::glsl::GoboTableFormulas<double> formulas;
    EXPECT_EQ(formulas.GOBO_TABLE_WIDTH, render::kGoboTableWidth);
    EXPECT_EQ(formulas.GOBO_TABLE_HEIGHT, render::kGoboTableHeight);
    EXPECT_EQ(formulas.GOBO_TABLE_LEVELS, render::kGoboLevels);
}

TEST(GoboTable, ItsLevelsDoNotOverlap) {
    render::glsl::GoboTableFormulas<double> formulas;
    std::vector<int> taken(std::size_t{render::kGoboTableWidth} * render::kGoboTableHeight, 0);
    for (int level = 0; level < formulas.GOBO_TABLE_LEVELS; ++level) {
        const glm::ivec4 place(formulas.goboTableLevel(level));
        ASSERT_LE(place.x + place.z + 1, render::kGoboTableWidth);
        ASSERT_LE(place.y + place.w, render::kGoboTableHeight);
        for (int row = place.y; row < place.y + place.w; ++row) {
            for (int column = place.x; column <= place.x + place.z; ++column)
                EXPECT_EQ(taken[static_cast<std::size_t>(row * render::kGoboTableWidth + column)]++, 0);
        }
    }
}

TEST(GoboTable, StopsWhenAskedTo) {
    std::stop_source stop;
    stop.request_stop();
    const GoboTable table = buildGoboTable(letterGobo(), {}, stop.get_token());
    EXPECT_EQ(table.layers, 0);
    EXPECT_TRUE(table.halves.empty());
}

/// The moments of a line between those of a grid.
glm::vec4 between(const std::vector<glm::vec4>& moments, const render::GoboLineGrid& grid,
                  const View::GoboLine& line) {
    const float column = line.turn * static_cast<float>(grid.turns);
    const float row = line.distance * static_cast<float>(grid.distances - 1);
    const auto at = [&](int right, int below) {
        const int turn = (static_cast<int>(column) + right) % grid.turns;
        return moments[static_cast<std::size_t>((static_cast<int>(row) + below) * grid.turns + turn)];
    };
    const float across = column - std::floor(column);
    const float down = row - std::floor(row);
    return (1.0f - down) * ((1.0f - across) * at(0, 0) + across * at(1, 0)) +
           down * ((1.0f - across) * at(0, 1) + across * at(1, 1));
}

/// As errorOf(), of the sharp level sampled on a grid.
double errorOfGrid(const Rays& rays, const GoboPicture& picture, const GoboLamp& lamp,
                   const render::GoboLineGrid& grid) {
    const auto moments = render::goboLineMoments(picture, 0, 0, goboProfile(lamp), grid);
    double squares = 0.0;
    for (std::size_t i = 0; i < rays.direct.size(); ++i) {
        View view = rays.views[i];
        const glm::vec4 coefficients = view.goboCoefficients(view.values, view.spread);
        const auto drawn = static_cast<double>(glm::dot(coefficients, between(moments, grid, view.line)));
        const double error = drawn - rays.direct[i].through(picture.levels[0], 0);
        squares += std::pow(error / rays.direct[i].withoutGobo(), 2);
    }
    return std::sqrt(squares / static_cast<double>(rays.direct.size()));
}

// How much a finer table would bring: the figures of docs/rendering.md.
TEST(GoboTable, ErrorFallsWithItsSize) {
    const GoboLamp lamp = flatLamp(12.0);
    const Rays rays(lamp, 500);
    const std::vector<render::GoboLineGrid> grids{
        {360, 65, 1}, {512, 129, 1}, {720, 129, 1}, {512, 257, 1}, {1440, 257, 1}};
    for (const NamedGobo& gobo : drawnGobos()) {
        if (gobo.name == "white") continue;
        fmt::print("{:>14}:", gobo.name);
        std::vector<double> errors;
        for (const render::GoboLineGrid& grid : grids) {
            errors.push_back(errorOfGrid(rays, gobo.picture, lamp, grid));
            fmt::print(" {}x{} {:.2f} %", grid.turns, grid.distances, 100.0 * errors.back());
        }
        fmt::print("\n");
        EXPECT_LT(errors.back(), 0.7 * errors.front());
    }
}

}  // namespace
}  // namespace hazer::test
