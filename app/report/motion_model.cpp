#include "app/report/motion_model.h"

#include <utility>

#include "fixtures/fixture.h"

namespace hazer::app {
namespace {

class FixtureAxis : public AxisModel {
 public:
    explicit FixtureAxis(fixtures::MotionLimits limits) : axis_(limits) {}
    void settle(double position) override { axis_.settle(position); }
    void step(double target, double dtS) override { axis_.step(target, dtS); }
    double position() const override { return axis_.position(); }
    double speed() const override { return axis_.speed(); }

 private:
    fixtures::MotionAxis axis_;
};

constexpr const char* kRotation = "Gobo1PosRotate";

/// A lamp of one channel, which turns its gobo.
fixtures::FixtureTypePtr typeWithWheel() {
    constexpr double kFastestDegPerS = 1e6;
    fixtures::ChannelFunction function;
    function.name = function.attribute = kRotation;
    function.dmxTo = 255;
    function.physicalFrom = -kFastestDegPerS;
    function.physicalTo = kFastestDegPerS;
    fixtures::DmxChannel channel;
    channel.geometryIndex = 0;
    channel.offsets = {1};
    channel.logicalChannels.push_back({kRotation, {function}});
    fixtures::DmxMode mode;
    mode.name = "Wheel";
    mode.geometry.kind = fixtures::GeometryKind::kBeam;
    mode.channels.push_back(std::move(channel));
    mode.footprint = 1;
    auto type = std::make_shared<fixtures::FixtureType>();
    type->modes.push_back(std::move(mode));
    return type;
}

class FixtureWheel : public WheelModel {
 public:
    explicit FixtureWheel(double degPerS) : fixture_("Wheel", typeWithWheel(), "Wheel", 1, glm::dmat4(1.0)) {
        fixture_.hold(kRotation, degPerS);
    }
    void step(double dtS) override { fixture_.step(dtS); }
    double angleDeg() const override { return fixture_.state().beams.front().gobos.front().rotationDeg; }

 private:
    fixtures::Fixture fixture_;
};

}  // namespace

std::unique_ptr<AxisModel> makeFixtureAxis(fixtures::MotionLimits limits) {
    return std::make_unique<FixtureAxis>(limits);
}

std::unique_ptr<WheelModel> makeFixtureWheel(double degPerS) {
    return std::make_unique<FixtureWheel>(degPerS);
}

}  // namespace hazer::app
