#include "app/window_frame_times.h"

#include <algorithm>
#include <cmath>

namespace hazer::app {

void WindowFrameTimes::add(double milliseconds) {
    if (count_ == kCapacity) {
        std::copy(history_.begin() + 1, history_.end(), history_.begin());
        --count_;
    }
    history_[count_++] = static_cast<float>(milliseconds);
}

double WindowFrameTimes::quantileMs(double share) const {
    if (count_ == 0) return 0.0;
    std::array<float, kCapacity> sorted = history_;
    const auto rank = static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(count_))) - 1;
    const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(count_);
    std::nth_element(sorted.begin(), sorted.begin() + rank, end);
    return static_cast<double>(sorted[static_cast<std::size_t>(rank)]);
}

}  // namespace hazer::app
