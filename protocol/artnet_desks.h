// The desks that polled us of late, and what else they asked for.
#pragma once

#include <cstddef>
#include <vector>

#include "protocol/artnet_poll.h"
#include "protocol/dmx.h"

namespace hazer::protocol {

struct ArtNetDesk {
    Endpoint endpoint{};
    ArtPoll poll{};  ///< Its last one.
    TimePoint lastPoll{};
};

/// Desks poll every few seconds; those that stopped are forgotten. Bounded: desks beyond are still answered,
/// but not told of changes.
class ArtNetDesks {
 public:
    static constexpr std::size_t kCapacity = 64;
    static constexpr std::chrono::seconds kForgetAfter{30};

    void hear(Endpoint from, const ArtPoll& poll, TimePoint now);

    /// Those that polled of late.
    const std::vector<ArtNetDesk>& all(TimePoint now);

 private:
    std::vector<ArtNetDesk> desks_;
};

}  // namespace hazer::protocol
