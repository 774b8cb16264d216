#include "protocol/recording/lateness.h"

#include <algorithm>

namespace hazer::protocol {

void Lateness::add(Clock::duration late) {
    late = std::max(late, Clock::duration::zero());
    worst_ = std::max(worst_, late);
    const auto us = static_cast<std::size_t>(std::chrono::ceil<std::chrono::microseconds>(late).count());
    ++counts_[std::min(us, kMostMicroseconds)];
    ++total_;
}

double Lateness::withinS(double share) const {
    const auto wanted = static_cast<std::uint64_t>(share * static_cast<double>(total_));
    std::uint64_t seen = 0;
    for (std::size_t us = 0; us < counts_.size(); ++us) {
        seen += counts_[us];
        if (seen > 0 && seen >= wanted) return static_cast<double>(us) * 1e-6;
    }
    return 0.0;
}

double Lateness::worstS() const {
    return std::chrono::duration<double>(worst_).count();
}

}  // namespace hazer::protocol
