// What became of the datagrams that arrived.
#pragma once

#include <cstdint>

namespace hazer::protocol {

/// Every datagram that arrived falls in exactly one of these, but for those that never reached us.
struct ReceiverCounters {
    std::uint64_t dmx = 0;      ///< ArtDmx taken into the merger.
    std::uint64_t late = 0;     ///< ArtDmx refused: sequence not newer than one already taken.
    std::uint64_t refused = 0;  ///< ArtDmx beyond a bound: a third source of a universe, too many universes.
    std::uint64_t polls = 0;    ///< ArtPoll that we answer.
    std::uint64_t syncs = 0;    ///< ArtSync that was obeyed.
    std::uint64_t control = 0;  ///< ArtAddress, ArtIpProg, ArtTimeCode and ArtTrigger that were taken.
    /// Art-Net that asks nothing of us: other packets, other start codes, no slots, polls for other nodes.
    std::uint64_t ignored = 0;
    std::uint64_t malformed = 0;  ///< Not Art-Net, or broken.
    std::uint64_t droppedBySystem =
        0;  ///< Arrived faster than they were read, and lost; counted by Linux alone.
};

}  // namespace hazer::protocol
