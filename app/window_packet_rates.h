// How often each universe arrives.
#pragma once

#include <map>

#include "protocol/universe_store.h"

namespace hazer::app {

class WindowPacketRates {
 public:
    /// Looks at what has arrived by `now`. Rates are renewed about once a second.
    void update(const protocol::UniverseSet& universes, protocol::TimePoint now);

    /// Packets per second; 0 for a universe that has not been watched for a second yet.
    double packetsPerS(protocol::UniverseId universe) const;

 private:
    struct Watched {
        protocol::TimePoint since;
        std::uint64_t packetCount = 0;  ///< At `since`.
        double packetsPerS = 0.0;
    };
    std::map<protocol::UniverseId, Watched> watched_;
};

}  // namespace hazer::app
