#include "app/report/motion_cases.h"

#include <cmath>
#include <cstddef>
#include <limits>

namespace hazer::app {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// A moving head's pan.
constexpr fixtures::MotionLimits kPan{216.0, 432.0};
/// Fast, and below what counts as no limit at all.
constexpr double kHuge = 9e11;

/// One movement by steps of a fixed length, cut short where it would take millions of them.
MotionCase byFixedSteps(const std::string& name, double stepS, double durationS) {
    return {name, kPan, -30.0, {{240.0, durationS}}, stepS};
}

/// There, halfway, and to the end.
MotionCase withLimits(const std::string& name, fixtures::MotionLimits limits, double halfwayS, double endS) {
    return {name, limits, -30.0, {{240.0, halfwayS}, {240.0, endS}}};
}

/// A fader swept up and down, as a console sends it: 44 values a second.
std::vector<MotionLeg> sweptFader() {
    constexpr int kValues = 440;
    std::vector<MotionLeg> legs;
    legs.reserve(kValues + 1);
    for (int i = 0; i < kValues; ++i) legs.push_back({120.0 * std::sin(0.05 * i), 1.0 / 44.0});
    legs.push_back({0.0, 20.0});
    return legs;
}

/// Two targets in turn, `times` times.
std::vector<MotionLeg> inTurn(double a, double b, double durationS, int times) {
    std::vector<MotionLeg> legs;
    legs.reserve(static_cast<std::size_t>(times) + 1);
    for (int i = 0; i < times; ++i) legs.push_back({i % 2 == 0 ? a : b, durationS});
    legs.push_back({a, 20.0});
    return legs;
}

void addStepLengths(std::vector<MotionCase>& cases) {
    cases.push_back(byFixedSteps("steps of 1e-6 s", 1e-6, 0.05));
    cases.push_back(byFixedSteps("steps of 1e-3 s", 1e-3, 4.0));
    cases.push_back(byFixedSteps("steps of 1/60 s", 1.0 / 60.0, 4.0));
    cases.push_back(byFixedSteps("steps of 1/25 s", 1.0 / 25.0, 4.0));
    cases.push_back(byFixedSteps("one step of 10 s", 10.0, 10.0));
    cases.push_back(byFixedSteps("one step of 1e4 s", 1e4, 1e4));
    cases.push_back({"steps of 1/60 s after a stall of 10 s",
                     kPan,
                     0.0,
                     {{90.0, 0.1}, {-90.0, 10.0}, {90.0, 0.5}, {90.0, 10.0}},
                     1.0 / 60.0});
}

void addLimits(std::vector<MotionCase>& cases) {
    cases.push_back(withLimits("huge acceleration", {216.0, kHuge}, 0.6, 4.0));
    cases.push_back(withLimits("huge speed", {kHuge, 432.0}, 0.8, 4.0));
    cases.push_back(withLimits("huge acceleration and speed", {kHuge, kHuge}, 1e-5, 1.0));
    cases.push_back(withLimits("no limit of acceleration", {216.0, kInfinity}, 0.6, 4.0));
    cases.push_back(withLimits("no limit of speed", {kInfinity, 432.0}, 0.8, 4.0));
    cases.push_back(withLimits("no limit at all", {kInfinity, kInfinity}, 1e-9, 1.0));
    cases.push_back(withLimits("next to no speed", {1e-6, 432.0}, 10.0, 1e4));
    cases.push_back(withLimits("next to no acceleration", {216.0, 1e-6}, 10.0, 1e4));
    cases.push_back(withLimits("next to no speed and acceleration", {1e-9, 1e-9}, 10.0, 1e4));
    cases.push_back(withLimits("slow part that is done after an hour", {0.1, 0.01}, 1300.0, 1e4));
}

void addTargets(std::vector<MotionCase>& cases) {
    cases.push_back({"target where the part stands", kPan, 30.0, {{30.0, 10.0}}});
    cases.push_back({"target a hair away", kPan, 30.0, {{30.0 + 1e-9, 1e-7}, {30.0 + 1e-9, 1.0}}});
    cases.push_back({"target a million degrees away", kPan, 0.0, {{1e6, 1000.0}, {1e6, 1e4}}});
    cases.push_back({"part a million degrees from zero", kPan, 1e6, {{1e6 + 90.0, 0.5}, {1e6 + 90.0, 10.0}}});
    cases.push_back({"target moves on midway", kPan, 0.0, {{90.0, 0.4}, {200.0, 0.4}, {200.0, 10.0}}});
    cases.push_back(
        {"target moves behind at full speed", kPan, 0.0, {{270.0, 0.8}, {-270.0, 0.3}, {-270.0, 10.0}}});
    cases.push_back(
        {"target moves behind while braking", kPan, 0.0, {{270.0, 1.6}, {0.0, 0.1}, {0.0, 10.0}}});
    // 0.5 s up to 216 deg/s and 54 deg; braking takes 54 deg more.
    cases.push_back(
        {"target moves to where braking ends", kPan, 0.0, {{270.0, 0.5}, {108.0, 0.2}, {108.0, 10.0}}});
    cases.push_back(
        {"target moves short of where braking ends", kPan, 0.0, {{270.0, 0.5}, {100.0, 0.2}, {100.0, 10.0}}});
    cases.push_back(
        {"target moves to where the part is", kPan, 0.0, {{270.0, 0.5}, {54.0, 0.1}, {54.0, 10.0}}});
    cases.push_back(
        {"target flickers a thousand times a second", kPan, 0.0, inTurn(100.0, -100.0, 1e-3, 1001)});
    cases.push_back({"target flickers by a hair", kPan, 0.0, inTurn(50.0, 50.0 + 1e-9, 1e-3, 1001)});
    cases.push_back({"there and back a hundred times", kPan, 0.0, inTurn(180.0, -180.0, 3.0, 101)});
    cases.push_back({"a fader swept by hand", kPan, 0.0, sweptFader()});
    cases.push_back({"a fader swept by hand, no inertia", {216.0, kInfinity}, 0.0, sweptFader()});
}

}  // namespace

std::vector<MotionCase> motionCases() {
    std::vector<MotionCase> cases;
    addStepLengths(cases);
    addLimits(cases);
    addTargets(cases);
    return cases;
}

std::vector<WheelCase> wheelCases() {
    return {{"wheel that stands", 0.0, 1e4, 1.0},
            {"wheel, one step of 1e4 s", 360.0, 1e4, 1e4},
            {"wheel, an hour of 1/60 s", 17.3, 3600.0, 1.0 / 60.0},
            {"wheel, backwards through zero", -90.0, 100.0, 1e-3},
            {"wheel, next to no speed", 1e-6, 1e4, 0.1},
            {"wheel, many turns a step", 1e5, 100.0, 0.1},
            {"wheel, whole turns a step", 3600.0, 100.0, 0.1}};
}

}  // namespace hazer::app
