#include "protocol/rate_meter.h"

#include <algorithm>

namespace hazer::protocol {

void RateMeter::count(TimePoint now) {
    const std::int64_t bucket = bucketOf(now);
    if (!hasAny_ || bucket - newest_ >= kBuckets) {
        counts_.fill(0);
        first_ = now;
        newest_ = bucket;
        hasAny_ = true;
    }
    for (; newest_ < bucket; ++newest_) counts_[static_cast<std::size_t>((newest_ + 1) % kBuckets)] = 0;
    ++counts_[static_cast<std::size_t>(bucket % kBuckets)];
}

double RateMeter::perSecond(TimePoint now) const {
    if (!hasAny_) return 0.0;
    const std::int64_t current = bucketOf(now);
    std::uint64_t sum = 0;
    for (std::int64_t bucket = std::max(current - kBuckets + 1, newest_ - kBuckets + 1); bucket <= newest_;
         ++bucket) {
        sum += counts_[static_cast<std::size_t>(bucket % kBuckets)];
    }
    const TimePoint windowStart{kBucketTime * (current - kBuckets + 1)};
    const double spanS = std::chrono::duration<double>(now - std::max(first_, windowStart)).count();
    // A second at least, or the first packet would look like a flood.
    return static_cast<double>(sum) / std::max(spanS, 1.0);
}

}  // namespace hazer::protocol
