// What became of the sACN datagrams that arrived.
#pragma once

#include <cstdint>

namespace hazer::protocol {

/// Every datagram that arrived falls in exactly one of these.
struct SacnCounters {
    std::uint64_t levels = 0;           ///< Levels taken, shown at once or held for synchronization.
    std::uint64_t slotPriorities = 0;   ///< Per-address priorities taken (start code 0xDD).
    std::uint64_t terminations = 0;     ///< Stream_Terminated; sources send three.
    std::uint64_t syncs = 0;            ///< Synchronization packets of an address that data has named.
    std::uint64_t discoveries = 0;      ///< Pages of universe discovery taken.
    std::uint64_t late = 0;             ///< Refused: sequence not newer than one already taken.
    std::uint64_t tooMany = 0;          ///< Refused: more sources or universes than there are places for.
    std::uint64_t otherPreview = 0;     ///< Preview data where live is wanted, or the other way round.
    std::uint64_t otherStartCodes = 0;  ///< Neither levels nor per-address priorities: text, RDM, tests.
    std::uint64_t ignored = 0;          ///< ACN that asks nothing of us.
    std::uint64_t malformed = 0;        ///< Not sACN, or broken.
};

}  // namespace hazer::protocol
