// What became of the datagrams that arrived.
#pragma once

#include <cstdint>

namespace hazer::protocol {

/// Every datagram that arrived falls in exactly one of these.
struct ReceiverCounters {
    std::uint64_t dmx = 0;      ///< ArtDmx taken into the store.
    std::uint64_t late = 0;     ///< ArtDmx refused: sequence not newer than one already taken.
    std::uint64_t refused = 0;  ///< Levels beyond a bound: a third source of a universe, too many universes.
    std::uint64_t polls = 0;    ///< ArtPoll that we answer.
    std::uint64_t ignored =
        0;  ///< Art-Net that asks nothing of us: other packets, no slots, polls for other nodes.
    std::uint64_t malformed = 0;  ///< Not Art-Net, or broken.
};

}  // namespace hazer::protocol
