// When synchronized sACN waits (ANSI E1.31-2018, sections 6.2.4, 6.2.6 and 11).
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "protocol/dmx.h"

namespace hazer::protocol {

/// A synchronization address as it stands.
struct SacnSyncStatus {
    std::uint16_t address = 0;
    bool hasSync = false;  ///< Synchronization packets have come: levels wait for them.
    bool isLost = false;   ///< They came, but not for 2.5 s.
    TimePoint lastSync{};  ///< If hasSync.
};

/// The synchronization addresses that data has named of late. Bounded: when all places are taken by ones that
/// are in use, levels with a further address show at once. Not thread-safe.
class SacnSyncTable {
 public:
    static constexpr std::size_t kCapacity = 64;

    /// Synchronization is lost after this time without a packet, and an address may lose its place after
    /// this time without data that names it.
    static constexpr std::chrono::milliseconds kLossAfter{2500};

    /// Levels with this address have come. True: they are to wait for the next synchronization packet.
    /// Address 0, and those beyond 63999 that older standards left open, mean no synchronization.
    bool mustWait(std::uint16_t address, bool forcesSync, TimePoint now);

    /// A synchronization packet has come. False: no data ever named the address, which nobody waits for.
    bool takeSync(std::uint16_t address, TimePoint now);

    /// Every address remembered, ascending.
    std::vector<SacnSyncStatus> status(TimePoint now) const;

    /// Grows whenever the set of addresses changes, so that groups can be joined.
    std::uint64_t revision() const { return revision_; }

 private:
    struct Entry {
        TimePoint lastData{};
        std::optional<TimePoint> lastSync{};
    };

    bool makeRoom(TimePoint now);

    std::map<std::uint16_t, Entry> entries_;
    std::uint64_t revision_ = 0;
};

}  // namespace hazer::protocol
