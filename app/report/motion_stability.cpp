#include "app/report/motion_stability.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace hazer::app {
namespace {

/// Keeps the worst deviation, and the first fault by name.
class Judge {
 public:
    explicit Judge(std::string name) { row_.name = std::move(name); }

    /// NaN is as far off as can be.
    void expectSmall(double deviation, const char* otherwise, double tolerance = kMotionTolerance) {
        if (std::isnan(deviation)) deviation = std::numeric_limits<double>::infinity();
        row_.worstDeviation = std::max(row_.worstDeviation, deviation);
        if (deviation > tolerance && row_.verdict.empty()) row_.verdict = otherwise;
    }

    void expect(bool holds, const char* otherwise) { expectSmall(holds ? 0.0 : 1.0, otherwise); }

    void countStep() { ++row_.steps; }

    MotionRow row() const {
        MotionRow row = row_;
        if (row.verdict.empty()) row.verdict = "ok";
        return row;
    }

 private:
    MotionRow row_;
};

struct State {
    double position = 0.0;
    double speed = 0.0;
};

State stateOf(const AxisModel& axis) {
    return {axis.position(), axis.speed()};
}

/// Where a leg may take a part that begins it in `from`: to the target, and to where it can stop.
struct Corridor {
    double low;
    double high;
};

Corridor corridorOf(const State& from, double target, const fixtures::MotionLimits& limits) {
    const double stop = from.position + 0.5 * from.speed * std::abs(from.speed) / limits.maxAcceleration;
    return {std::min({from.position, target, stop}), std::max({from.position, target, stop})};
}

/// A limit times a time; nothing in no time, even without a limit.
double within(double limit, double dtS) {
    return dtS > 0.0 ? limit * dtS : 0.0;
}

/// Drives one part through one case and watches every step.
class Drive {
 public:
    Drive(const MotionCase& motion, const AxisMaker& make, Judge& judge)
        : limits_(motion.limits), axis_(make(motion.limits)), judge_(judge) {
        axis_->settle(motion.start);
        double farthest = std::abs(motion.start);
        for (const MotionLeg& leg : motion.legs) {
            way_ = std::max(way_, std::abs(leg.target - motion.start));
            farthest = std::max(farthest, std::abs(leg.target));
        }
        if (way_ == 0.0) way_ = 1.0;
        // Numbers far from zero have that much coarser a last digit.
        tolerance_ += kLastDigits * farthest / way_;
    }

    void beginLeg(double target) {
        target_ = target;
        expectFinite();
        corridor_ = corridorOf(stateOf(*axis_), target, limits_);
    }

    void step(double dtS) {
        const State before = stateOf(*axis_);
        axis_->step(target_, dtS);
        judge_.countStep();
        const State after = stateOf(*axis_);
        expectFinite();
        expectWay(std::max(corridor_.low - after.position, after.position - corridor_.high), "overshoots");
        expectSpeed(std::abs(after.speed) - limits_.maxSpeed, "is too fast");
        expectSpeed(std::abs(after.speed - before.speed) - within(limits_.maxAcceleration, dtS),
                    "accelerates too much");
        expectWay(std::abs(after.position - before.position) - within(limits_.maxSpeed, dtS), "jumps");
    }

    State state() const { return stateOf(*axis_); }

    void compare(const State& expected) {
        expectWay(std::abs(state().position - expected.position), "depends on the division of time");
        expectSpeed(std::abs(state().speed - expected.speed), "depends on the division of time");
    }

    /// More steps of every length once the target is reached.
    void expectRest() {
        if (state().position != target_ || state().speed != 0.0) return;
        for (int i = 0; i < 200; ++i) {
            step(std::pow(10.0, -6.0 + 10.0 * (i % 20) / 19.0));
            judge_.expect(state().position == target_ && state().speed == 0.0, "drifts");
        }
    }

 private:
    static constexpr double kLastDigits = 1e-13;

    void expectFinite() {
        judge_.expect(std::isfinite(state().position) && std::isfinite(state().speed), "is not finite");
    }

    /// `excess`, over what is allowed, as a share of the way.
    void expectWay(double excess, const char* otherwise) {
        judge_.expectSmall(std::max(excess, 0.0) / way_, otherwise, tolerance_);
    }

    /// Speeds are compared with the fastest that the way and the limits allow.
    void expectSpeed(double excess, const char* otherwise) {
        const double fastest = std::min(limits_.maxSpeed, std::sqrt(way_ * limits_.maxAcceleration));
        // A part without limits is never seen to move.
        const double share = std::isinf(fastest) ? excess : std::max(excess, 0.0) / fastest;
        judge_.expectSmall(std::max(share, 0.0), otherwise, tolerance_);
    }

    fixtures::MotionLimits limits_;
    std::unique_ptr<AxisModel> axis_;
    Judge& judge_;
    double way_ = 0.0;  ///< Farthest target from the start.
    double tolerance_ = kMotionTolerance;
    double target_ = 0.0;
    Corridor corridor_{0.0, 0.0};
};

/// Shortest time from rest to rest over `way`.
double shortestTimeS(double way, const fixtures::MotionLimits& limits) {
    if (std::isinf(limits.maxAcceleration)) return way / limits.maxSpeed;
    const double ramp = limits.maxSpeed * limits.maxSpeed / limits.maxAcceleration;
    if (way <= ramp) return 2.0 * std::sqrt(way / limits.maxAcceleration);
    return way / limits.maxSpeed + limits.maxSpeed / limits.maxAcceleration;
}

/// From rest, the part is at the first target when the closed form says so, and not before.
void expectPunctual(const MotionCase& motion, const AxisMaker& make, Judge& judge) {
    constexpr double kSlack = 1e-6;
    const double target = motion.legs.front().target;
    const double needsS = shortestTimeS(std::abs(target - motion.start), motion.limits);
    if (needsS == 0.0) return;
    Drive drive(motion, make, judge);
    drive.beginLeg(target);
    drive.step(needsS * (1.0 - kSlack));
    judge.expect(drive.state().position != target || drive.state().speed != 0.0, "arrives early");
    drive.step(needsS * 2.0 * kSlack);
    judge.expect(drive.state().position == target && drive.state().speed == 0.0, "arrives late");
}

/// One step a leg; the states that every other division is held against.
std::vector<State> driveWhole(const MotionCase& motion, const AxisMaker& make, Judge& judge) {
    Drive drive(motion, make, judge);
    std::vector<State> states;
    for (const MotionLeg& leg : motion.legs) {
        drive.beginLeg(leg.target);
        drive.step(leg.durationS);
        states.push_back(drive.state());
    }
    drive.expectRest();
    return states;
}

/// Random lengths that add up, of very different sizes, and steps of nothing in between.
std::vector<double> randomDivision(double durationS, int parts, std::mt19937_64& random) {
    std::uniform_real_distribution<double> place(0.0, 1.0);
    std::vector<double> cuts{0.0, durationS};
    for (int i = 1; i < parts; ++i) {
        // Half of them crowd at the beginning.
        const double share = i % 2 == 0 ? place(random) : std::pow(10.0, -9.0 * place(random));
        cuts.push_back(durationS * share);
    }
    std::sort(cuts.begin(), cuts.end());
    std::vector<double> steps{0.0};
    for (std::size_t i = 1; i < cuts.size(); ++i) steps.push_back(cuts[i] - cuts[i - 1]);
    return steps;
}

std::vector<double> fixedDivision(double durationS, double stepS) {
    const auto whole = static_cast<std::size_t>(durationS / stepS * (1.0 + 1e-12));
    std::vector<double> steps(whole, stepS);
    const double rest = durationS - stepS * static_cast<double>(whole);
    if (rest > 0.0) steps.push_back(rest);
    return steps;
}

template <typename Divide>
void driveDivided(const MotionCase& motion, const AxisMaker& make, const std::vector<State>& expected,
                  Judge& judge, Divide divide) {
    Drive drive(motion, make, judge);
    for (std::size_t i = 0; i < motion.legs.size(); ++i) {
        drive.beginLeg(motion.legs[i].target);
        for (const double dtS : divide(motion.legs[i].durationS)) drive.step(dtS);
        drive.compare(expected[i]);
    }
    drive.expectRest();
}

/// Between two angles, the short way round.
double angleBetweenDeg(double a, double b) {
    return std::abs(std::remainder(a - b, 360.0));
}

}  // namespace

MotionRow checkMotion(const MotionCase& motion, const AxisMaker& make) {
    Judge judge(motion.name);
    const std::vector<State> expected = driveWhole(motion, make, judge);
    if (motion.stepS > 0.0) {
        driveDivided(motion, make, expected, judge,
                     [&](double durationS) { return fixedDivision(durationS, motion.stepS); });
    }
    std::mt19937_64 random(1);
    const int most = motion.legs.size() > 10 ? 30 : 3000;
    for (const int parts : {2, 7, most}) {
        driveDivided(motion, make, expected, judge,
                     [&](double durationS) { return randomDivision(durationS, parts, random); });
    }
    expectPunctual(motion, make, judge);
    return judge.row();
}

MotionRow checkRefusals(const AxisMaker& make) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Judge judge("parameters that are no numbers");
    const auto asked = make({216.0, 432.0});
    const auto spared = make({216.0, 432.0});
    for (int i = 0; i < 100; ++i) {
        for (const double bad : {kNan, kInfinity, -kInfinity}) {
            asked->settle(bad);
            asked->step(bad, 0.01);
            asked->step(90.0, bad);
            asked->step(bad, bad);
        }
        asked->step(-90.0, -0.01);
        asked->step(-90.0, 0.0);
        judge.expect(asked->position() == spared->position() && asked->speed() == spared->speed(),
                     "takes what is no number");
        for (AxisModel* axis : {asked.get(), spared.get()}) axis->step(90.0, 0.02);
        judge.countStep();
    }
    judge.expect(asked->position() == 90.0 && asked->speed() == 0.0, "does not arrive");
    return judge.row();
}

MotionRow checkWheel(const WheelCase& wheel, const WheelMaker& make) {
    Judge judge(wheel.name);
    const auto turning = make(wheel.degPerS);
    const auto steps = static_cast<int>(std::lround(wheel.durationS / wheel.stepS));
    for (int i = 1; i <= steps; ++i) {
        turning->step(wheel.stepS);
        judge.countStep();
        const double angle = turning->angleDeg();
        judge.expect(angle >= 0.0 && angle < 360.0, "leaves 0..360 degrees");
        const long double whole = static_cast<long double>(wheel.degPerS) * wheel.stepS * i;
        const auto expected = static_cast<double>(std::fmod(whole, 360.0L));
        judge.expectSmall(angleBetweenDeg(angle, expected) / 360.0, "drifts");
    }
    return judge.row();
}

std::vector<MotionRow> motionStability(const AxisMaker& axis, const WheelMaker& wheel) {
    std::vector<MotionRow> rows;
    for (const MotionCase& motion : motionCases()) rows.push_back(checkMotion(motion, axis));
    rows.push_back(checkRefusals(axis));
    for (const WheelCase& turning : wheelCases()) rows.push_back(checkWheel(turning, wheel));
    return rows;
}

}  // namespace hazer::app
