// A moved part as the checks of its stability drive it, so that they can be tried on one that is wrong.
#pragma once

#include <functional>
#include <memory>

#include "fixtures/motion.h"

namespace hazer::app {

/// Pan, tilt: a part that goes to a target and stops there.
class AxisModel {
 public:
    virtual ~AxisModel() = default;
    virtual void settle(double position) = 0;
    virtual void step(double target, double dtS) = 0;
    virtual double position() const = 0;
    virtual double speed() const = 0;
};

/// A wheel that turns on and on.
class WheelModel {
 public:
    virtual ~WheelModel() = default;
    virtual void step(double dtS) = 0;
    virtual double angleDeg() const = 0;
};

using AxisMaker = std::function<std::unique_ptr<AxisModel>(fixtures::MotionLimits)>;
using WheelMaker = std::function<std::unique_ptr<WheelModel>(double degPerS)>;

/// What hazer moves its fixtures by: fixtures::MotionAxis.
std::unique_ptr<AxisModel> makeFixtureAxis(fixtures::MotionLimits limits);

/// The rotating gobo of a fixtures::Fixture, at up to 1e6 degrees a second either way.
std::unique_ptr<WheelModel> makeFixtureWheel(double degPerS);

}  // namespace hazer::app
