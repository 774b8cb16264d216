// How late things happened, as a histogram of microseconds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "protocol/dmx.h"

namespace hazer::protocol {

/// Exact to a microsecond up to 100 ms; what is later counts as 100 ms in the shares, and whole in worstS.
class Lateness {
 public:
    void add(Clock::duration late);

    /// What `share` of all (0..1) stay within [s]; 0 if there are none.
    double withinS(double share) const;
    double worstS() const;

 private:
    static constexpr std::size_t kMostMicroseconds = 100'000;

    std::vector<std::uint64_t> counts_ = std::vector<std::uint64_t>(kMostMicroseconds + 1);
    std::uint64_t total_ = 0;
    Clock::duration worst_{};
};

}  // namespace hazer::protocol
