#include "app/time_code_follower.h"

#include <algorithm>
#include <cmath>

namespace hazer::app {
namespace {

// One part in so many of a code's deviation is corrected with each code: at 25 codes a second, half of a
// lasting one within a quarter of a second.
constexpr int kSmoothing = 10;

TimeCodeFollower::Time timeOf(const protocol::ArtTimeCode& code) {
    constexpr double kNanosecondsPerS = 1e9;
    return TimeCodeFollower::Time(std::llround(code.timeS() * kNanosecondsPerS));
}

}  // namespace

void TimeCodeFollower::take(const protocol::ReceivedTimeCode& received) {
    const Code code{timeOf(received.code), received.time, received.from.address};
    if (last_ && code.time == last_->time) return;
    if (last_ && code.from != last_->from && code.arrival - last_->arrival < kStandsAfter) return;
    run(code);
    last_ = code;
}

void TimeCodeFollower::run(const Code& code) {
    const bool comesAlone = !last_ || code.arrival - last_->arrival >= kStandsAfter;
    if (comesAlone) return jump(code);
    // Of a code that stood until now, the one before tells whether this one goes on from it.
    const protocol::TimePoint expectedAtZero = clockAtZero_.value_or(last_->arrival - last_->time);
    const protocol::TimePoint atZero = code.arrival - code.time;
    const Time deviation = atZero - expectedAtZero;
    if (deviation > kJumpsBeyond || deviation < -kJumpsBeyond || (!clockAtZero_ && code.time < last_->time)) {
        return jump(code);
    }
    clockAtZero_ = clockAtZero_ ? *clockAtZero_ + deviation / kSmoothing : atZero;
}

void TimeCodeFollower::jump(const Code& code) {
    clockAtZero_.reset();
    position_ = code.time;
}

std::optional<TimeCodeFollower::Time> TimeCodeFollower::position(protocol::TimePoint now) {
    if (!last_) return std::nullopt;
    if (now - last_->arrival >= kStandsAfter) jump(*last_);
    if (clockAtZero_) position_ = std::max(position_, Time(now - *clockAtZero_));
    return position_;
}

}  // namespace hazer::app
