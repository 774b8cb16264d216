// How long the latest frames took, from one picture on the screen to the next.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace hazer::app {

class WindowFrameTimes {
 public:
    void add(double milliseconds);

    /// The latest frames [ms], oldest first, at most kCapacity.
    std::span<const float> history() const { return {history_.data(), count_}; }

    double medianMs() const { return quantileMs(0.5); }
    double percentile99Ms() const { return quantileMs(0.99); }

    static constexpr std::size_t kCapacity = 240;  ///< 4 s at 60 frames a second.

 private:
    double quantileMs(double share) const;

    std::array<float, kCapacity> history_{};
    std::size_t count_ = 0;
};

}  // namespace hazer::app
