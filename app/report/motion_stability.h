// Whether moved parts behave for every division of time: no overshoot, no drift, one end state.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/report/motion_cases.h"
#include "app/report/motion_model.h"

namespace hazer::app {

struct MotionRow {
    std::string name;
    std::int64_t steps = 0;
    /// Largest fault found, as a share of the way that the case covers (for a wheel: of a turn). Speeds count
    /// as a share of the highest speed.
    double worstDeviation = 0.0;
    std::string verdict;  ///< "ok", or what is wrong first.

    bool passed() const { return verdict == "ok"; }
};

/// Above this, a deviation is a fault and not rounding.
inline constexpr double kMotionTolerance = 1e-9;

/// Drives one case in one step a leg, in the case's own steps and in random divisions of time (always the
/// same ones), and checks every step:
/// - the state at the end of each leg is the same however time was divided;
/// - the part never leaves the way from where it is to its target, but to brake;
/// - speed, acceleration and way stay within the limits;
/// - from rest, it arrives when the closed form of the trapezoid says so, not before, and exactly there;
/// - once there it stays, bit for bit;
/// - everything is finite.
MotionRow checkMotion(const MotionCase& motion, const AxisMaker& make);

/// A target, time or position that is no number, infinite, or a time below zero changes nothing, and the part
/// moves on as if it had not been asked.
MotionRow checkRefusals(const AxisMaker& make);

/// The angle is speed x time to within rounding, and in 0..360 degrees.
MotionRow checkWheel(const WheelCase& wheel, const WheelMaker& make);

/// All of it, for the parts of hazer's fixtures unless others are given.
std::vector<MotionRow> motionStability(const AxisMaker& axis = makeFixtureAxis,
                                       const WheelMaker& wheel = makeFixtureWheel);

}  // namespace hazer::app
