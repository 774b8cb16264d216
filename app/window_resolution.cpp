#include "app/window_resolution.h"

#include <algorithm>
#include <cmath>

namespace hazer::app {
namespace {

/// Where the automatic aims, below kSlowMs so that it does not come back at once.
constexpr double kGoalMs = 40.0;

/// Factors are multiples of this: each change makes new render targets, so small ones are not worth it.
constexpr double kStep = 0.0625;

/// The time of a picture goes with the number of its pixels.
double predictedMs(double pictureMs, double factor, double newFactor) {
    return pictureMs * (newFactor * newFactor) / (factor * factor);
}

}  // namespace

void WindowResolution::setAutomatic(bool isAutomatic) {
    isAutomatic_ = isAutomatic;
    frames_ = 0;
}

void WindowResolution::setFactor(double factor) {
    factor_ = std::clamp(factor, kMinFactor, 1.0);
    setAutomatic(false);
}

void WindowResolution::add(double pictureMs) {
    if (!isAutomatic_ || ++frames_ <= kLateFrames) return;
    // The fastest of a few, since a single slow one may be the machine's doing, not the picture's.
    fastestMs_ = frames_ == kLateFrames + 1 ? pictureMs : std::min(fastestMs_, pictureMs);
    if (frames_ < kLateFrames + kJudgedFrames) return;
    frames_ = 0;
    judge(fastestMs_);
}

void WindowResolution::judge(double pictureMs) {
    if (pictureMs > kSlowMs) {
        const double wanted = factor_ * std::sqrt(kGoalMs / pictureMs);
        factor_ = std::max(kMinFactor, std::floor(wanted / kStep) * kStep);
        return;
    }
    const double finer = std::min(1.0, factor_ + kStep);
    if (predictedMs(pictureMs, factor_, finer) < kGoalMs) factor_ = finer;
}

glm::ivec2 WindowResolution::drawnSize(const glm::ivec2& shown) const {
    return glm::max(glm::ivec2(1), glm::ivec2(glm::round(glm::dvec2(shown) * factor_)));
}

}  // namespace hazer::app
