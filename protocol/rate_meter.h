// How many packets a second have come of late.
#pragma once

#include <array>
#include <cstdint>

#include "protocol/dmx.h"

namespace hazer::protocol {

/// Counts events in the half seconds of the last three seconds. Times must not go back.
class RateMeter {
 public:
    void count(TimePoint now);

    /// Events per second over the last three seconds, or since the first one if that is later; 0 after
    /// three seconds without any.
    double perSecond(TimePoint now) const;

 private:
    static constexpr std::chrono::milliseconds kBucketTime{500};
    static constexpr std::int64_t kBuckets = 6;

    static std::int64_t bucketOf(TimePoint time) { return time.time_since_epoch() / kBucketTime; }

    std::array<std::uint32_t, kBuckets> counts_{};
    std::int64_t newest_ =
        0;  ///< The bucket that counts_ was last written for, since the epoch of the clock.
    TimePoint first_{};
    bool hasAny_ = false;
};

}  // namespace hazer::protocol
