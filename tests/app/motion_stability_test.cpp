// The checks of motion pass what hazer moves its fixtures by, and catch parts that move wrongly.
#include "app/report/motion_stability.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace hazer::test {
namespace {

using app::AxisModel;
using app::MotionRow;
using fixtures::MotionAxis;
using fixtures::MotionLimits;

TEST(MotionStability, HazersFixturesPassEveryCase) {
    const std::vector<MotionRow> rows = app::motionStability();
    EXPECT_GE(rows.size(), 40u);
    std::set<std::string> names;
    for (const MotionRow& row : rows) {
        EXPECT_EQ(row.verdict, "ok") << row.name << ": " << row.worstDeviation;
        EXPECT_TRUE(std::isfinite(row.worstDeviation)) << row.name;
        EXPECT_GT(row.steps, 0) << row.name;
        names.insert(row.name);
    }
    EXPECT_EQ(names.size(), rows.size()) << "a name stands for one case";
}

/// hazer's axis, to be spoiled in one respect.
class SpoiledAxis : public AxisModel {
 public:
    explicit SpoiledAxis(MotionLimits limits) : axis_(limits) {}
    void settle(double position) override { axis_.settle(position); }
    void step(double target, double dtS) override { axis_.step(target, dtS); }
    double position() const override { return axis_.position(); }
    double speed() const override { return axis_.speed(); }

 protected:
    MotionAxis axis_;
};

/// What games do: speed first, then position, by the length of the frame.
class EulerAxis : public AxisModel {
 public:
    explicit EulerAxis(MotionLimits limits) : limits_(limits) {}
    void settle(double position) override { position_ = position; }
    void step(double target, double dtS) override {
        if (!std::isfinite(target) || !std::isfinite(dtS) || dtS <= 0.0) return;
        const double spare = target - position_ - 0.5 * speed_ * std::abs(speed_) / limits_.maxAcceleration;
        const double change = limits_.maxAcceleration * dtS;
        speed_ += std::clamp(std::copysign(limits_.maxSpeed, spare) - speed_, -change, change);
        position_ += speed_ * dtS;
    }
    double position() const override { return position_; }
    double speed() const override { return speed_; }

 private:
    MotionLimits limits_;
    double position_ = 0.0;
    double speed_ = 0.0;
};

/// Moves a thousandth past a target at which it stops.
class Overshooting : public SpoiledAxis {
 public:
    using SpoiledAxis::SpoiledAxis;
    void settle(double position) override {
        start_ = position;
        axis_.settle(position);
    }
    double position() const override { return start_ + 1.001 * (axis_.position() - start_); }

 private:
    double start_ = 0.0;
};

/// Arrives, and begins to creep after a while.
class Creeping : public SpoiledAxis {
 public:
    using SpoiledAxis::SpoiledAxis;
    void step(double target, double dtS) override {
        if (axis_.position() == target && axis_.speed() == 0.0) ++rests_;
        axis_.step(target, dtS);
    }
    double position() const override { return axis_.position() - (rests_ > 100 ? 1e-12 : 0.0); }

 private:
    int rests_ = 0;
};

/// Forgets what is left of a step when a part of it ends.
class Jumping : public SpoiledAxis {
 public:
    using SpoiledAxis::SpoiledAxis;
    void step(double target, double dtS) override {
        if (std::isfinite(target) && dtS > 0.0) axis_.settle(target);
    }
};

class Slow : public SpoiledAxis {
 public:
    using SpoiledAxis::SpoiledAxis;
    void step(double target, double dtS) override { axis_.step(target, 0.99 * dtS); }
};

/// Twice the acceleration that its motor has.
class Strong : public SpoiledAxis {
 public:
    explicit Strong(MotionLimits limits) : SpoiledAxis({limits.maxSpeed, 2.0 * limits.maxAcceleration}) {}
};

class Trusting : public SpoiledAxis {
 public:
    using SpoiledAxis::SpoiledAxis;
    void step(double target, double dtS) override {
        if (std::isnan(target)) axis_.settle(0.0);
        axis_.step(target, dtS);
    }
};

class NotFinite : public SpoiledAxis {
 public:
    using SpoiledAxis::SpoiledAxis;
    double position() const override { return std::sqrt(axis_.position()); }
};

template <typename Model>
app::AxisMaker maker() {
    return [](MotionLimits limits) { return std::make_unique<Model>(limits); };
}

template <typename Model>
std::string verdictOfSimpleMotion() {
    return app::checkMotion({"simple", {216.0, 432.0}, -30.0, {{240.0, 1.0}, {240.0, 5.0}}, 1.0 / 60.0},
                            maker<Model>())
        .verdict;
}

TEST(MotionStability, CatchesPartsThatMoveWrongly) {
    EXPECT_EQ(verdictOfSimpleMotion<SpoiledAxis>(), "ok");
    EXPECT_EQ(verdictOfSimpleMotion<EulerAxis>(), "overshoots");
    EXPECT_EQ(verdictOfSimpleMotion<Overshooting>(), "overshoots");
    EXPECT_EQ(verdictOfSimpleMotion<Jumping>(), "jumps");
    EXPECT_EQ(verdictOfSimpleMotion<Slow>(), "arrives late");
    EXPECT_EQ(verdictOfSimpleMotion<Strong>(), "accelerates too much");
    EXPECT_EQ(verdictOfSimpleMotion<NotFinite>(), "is not finite");
}

TEST(MotionStability, CatchesWhatDependsOnTheDivisionOfTime) {
    const auto verdict = [](const app::AxisMaker& make) {
        return app::checkMotion({"midway", {216.0, 432.0}, 0.0, {{200.0, 0.3}}, 1e-3}, make).verdict;
    };
    EXPECT_EQ(verdict(maker<SpoiledAxis>()), "ok");
    EXPECT_EQ(verdict(maker<EulerAxis>()), "depends on the division of time");
}

TEST(MotionStability, CatchesDrift) {
    // Far less than rounding on the way, but a part at rest is to stand still, bit for bit.
    const app::MotionCase rest{"rest", {216.0, 432.0}, 0.0, {{90.0, 5.0}}};
    EXPECT_EQ(app::checkMotion(rest, maker<SpoiledAxis>()).verdict, "ok");
    EXPECT_EQ(app::checkMotion(rest, maker<Creeping>()).verdict, "drifts");
}

TEST(MotionStability, CatchesPartsThatTakeWhatIsNoNumber) {
    EXPECT_EQ(app::checkRefusals(maker<SpoiledAxis>()).verdict, "ok");
    EXPECT_EQ(app::checkRefusals(maker<Trusting>()).verdict, "takes what is no number");
}

/// Adds up angles in float, and never wraps if told so.
class FloatWheel : public app::WheelModel {
 public:
    FloatWheel(double degPerS, bool wraps) : degPerS_(static_cast<float>(degPerS)), wraps_(wraps) {}
    void step(double dtS) override {
        angleDeg_ += degPerS_ * static_cast<float>(dtS);
        if (wraps_) angleDeg_ = std::fmod(angleDeg_, 360.0f);
    }
    double angleDeg() const override { return static_cast<double>(angleDeg_); }

 private:
    float degPerS_;
    bool wraps_;
    float angleDeg_ = 0.0f;
};

TEST(MotionStability, CatchesWheelsThatDriftOrDoNotWrap) {
    const app::WheelCase wheel{"wheel", 17.3, 60.0, 1.0 / 60.0};
    const auto verdict = [&](bool wraps) {
        return app::checkWheel(wheel,
                               [=](double degPerS) { return std::make_unique<FloatWheel>(degPerS, wraps); })
            .verdict;
    };
    EXPECT_EQ(app::checkWheel(wheel, app::makeFixtureWheel).verdict, "ok");
    EXPECT_EQ(verdict(true), "drifts");
    EXPECT_EQ(app::checkWheel({"wheel", 90.0, 10.0, 1.0},
                              [](double degPerS) { return std::make_unique<FloatWheel>(degPerS, false); })
                  .verdict,
              "leaves 0..360 degrees");
}

}  // namespace
}  // namespace hazer::test
