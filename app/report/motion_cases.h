// Motions that are hard to keep stable, by name.
#pragma once

#include <string>
#include <vector>

#include "fixtures/motion.h"

namespace hazer::app {

/// For so long [s] a part is told to be at a target.
struct MotionLeg {
    double target;
    double durationS;
};

/// A part at rest at `start`, and what it is told in turn. Positions in degrees.
struct MotionCase {
    std::string name;
    fixtures::MotionLimits limits;
    double start;
    std::vector<MotionLeg> legs;
    double stepS = 0.0;  ///< One of the ways that time is divided, besides random ones; 0: random ones only.
};

std::vector<MotionCase> motionCases();

/// A wheel that turns for `durationS` in steps of `stepS`.
struct WheelCase {
    std::string name;
    double degPerS;
    double durationS;
    double stepS;
};

std::vector<WheelCase> wheelCases();

}  // namespace hazer::app
