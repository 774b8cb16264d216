// Who else is on the network: names, and who of them synchronizes.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "protocol/dmx.h"
#include "protocol/endpoint.h"
#include "protocol/universe_merger.h"

namespace hazer::protocol {

struct ArtNetPeer {
    std::string address;  ///< As people write it.
    std::string name;     ///< From its ArtPollReply; empty until it sends one.
    TimePoint lastHeard{};
    bool hasSentLevels = false;
    bool isSynchronous = false;  ///< Its levels wait for its next ArtSync.
    TimePoint lastSync{};
};

struct SyncTimeOut {
    Ipv4Address address{};
    TimePoint time{};
};

/// The levels that wait for an ArtSync from `address`.
SyncGroup syncGroupOf(Ipv4Address address);

/// Bounded: when it is full of those that sent levels in the last seconds, further ones have neither name nor
/// synchronization. Not thread-safe.
class ArtNetPeers {
 public:
    static constexpr std::size_t kCapacity = 256;
    static constexpr std::chrono::seconds kForgetAfter{10};

    /// After so long without an ArtSync levels show at once again (section ArtSync).
    static constexpr std::chrono::seconds kSyncTimeOut{4};

    /// Remembers that levels came from there. Null if there is no room.
    const ArtNetPeer* hearLevels(Ipv4Address from, TimePoint now);

    void setName(Ipv4Address of, std::string_view name, TimePoint now);

    /// Whether an ArtSync from there counts: only from somebody whose levels we have.
    bool takeSync(Ipv4Address from, TimePoint now);

    /// When the next peer goes back to showing at once; TimePoint::max(): never.
    TimePoint nextSyncTimeOut() const { return nextSyncTimeOut_; }

    /// A peer whose synchronization timed out by `now`, which shows at once from then on; call until there is
    /// none.
    std::optional<SyncTimeOut> takeSyncTimeOut(TimePoint now);

 private:
    ArtNetPeer* place(Ipv4Address address, bool sendsLevels, TimePoint now);
    bool makeRoom(TimePoint now);

    std::map<Ipv4Address, ArtNetPeer> peers_;
    TimePoint nextSyncTimeOut_ = TimePoint::max();
    TimePoint nextSweep_{};
};

}  // namespace hazer::protocol
