#include "app/window_resolution.h"

#include <algorithm>
#include <cmath>

namespace hazer::app {
namespace {

/// Where the automatic aims, below kSlowMs so that it does not come back at once.
constexpr double kGoalMs = 40.0;

/// Factors are multiples of this: each change makes new render targets, so small ones are not worth it.
constexpr double kStep = 0.0625;

/// Nobody should sit through many pictures like this to get a coarser one.
constexpr double kVerySlowMs = 250.0;

}  // namespace

void WindowResolution::setAutomatic(bool isAutomatic) {
    isAutomatic_ = isAutomatic;
    frames_ = 0;
    verySlowInARow_ = 0;
}

void WindowResolution::setFactor(double factor) {
    factor_ = std::clamp(factor, kMinFactor, 1.0);
    setAutomatic(false);
}

void WindowResolution::add(double pictureMs) {
    if (!isAutomatic_ || pictureMs <= 0.0) return;
    verySlowInARow_ = pictureMs > kVerySlowMs ? verySlowInARow_ + 1 : 0;
    if (verySlowInARow_ > 1) return decide(pictureMs);
    if (++frames_ <= kLateFrames) return;
    // The fastest of a few, since a single slow one may be the machine's doing, not the picture's.
    fastestMs_ = frames_ == kLateFrames + 1 ? pictureMs : std::min(fastestMs_, pictureMs);
    if (frames_ == kLateFrames + kJudgedFrames) decide(fastestMs_);
}

void WindowResolution::decide(double pictureMs) {
    frames_ = 0;
    verySlowInARow_ = 0;
    // The time of a picture goes with the number of its pixels. It may only double in edge at once, since the
    // smallest times tell least about the largest pictures.
    const double wanted = std::clamp(factor_ * std::sqrt(kGoalMs / pictureMs), kMinFactor, 2.0 * factor_);
    const double stepped = std::min(1.0, std::floor(wanted / kStep) * kStep);
    if (pictureMs > kSlowMs || stepped > factor_) factor_ = stepped;
}

glm::ivec2 WindowResolution::drawnSize(const glm::ivec2& shown) const {
    return glm::max(glm::ivec2(1), glm::ivec2(glm::round(glm::dvec2(shown) * factor_)));
}

}  // namespace hazer::app
