// A receiver of sACN without sockets or clocks: datagrams and the time go in, levels come out into a merger.
// The rules are ANSI E1.31-2018's and, for per-address priority, ETC's; docs/sacn.md tells them in full.
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "protocol/endpoint.h"
#include "protocol/sacn.h"
#include "protocol/sacn_counters.h"
#include "protocol/sacn_discovered.h"
#include "protocol/sacn_streams.h"
#include "protocol/sacn_sync.h"
#include "protocol/universe_merger.h"

namespace hazer::protocol {

/// What a desk marks as Preview_Data is not meant for live output (E1.31 section 6.2.6). A visualizer is
/// whom it is meant for.
enum class PreviewRule : std::uint8_t {
    kBoth,         ///< Takes preview and live data alike.
    kLiveOnly,     ///< Leaves preview data alone, as a dimmer does.
    kPreviewOnly,  ///< Shows what is previewed, beside a desk that runs a show.
};

/// Not thread-safe; times handed in must not go back. Memory is bounded whatever arrives, and a packet of a
/// source and universe that are known allocates nothing.
class SacnListener {
 public:
    /// Universes remembered for having come by the group of another one.
    static constexpr std::size_t kMaxWrongGroups = 64;

    explicit SacnListener(PreviewRule preview = PreviewRule::kBoth) : preview_(preview) {}

    /// Takes one datagram of any content. `to` is where it arrived: an address of ours, or a multicast group.
    void receive(std::span<const std::uint8_t> datagram, const IpEndpoint& from, const IpEndpoint& to,
                 TimePoint now, UniverseMerger& merger);

    const SacnCounters& counters() const { return counters_; }

    /// Synchronization addresses that data has named, for display and to join their groups.
    const SacnSyncTable& syncTable() const { return sync_; }

    /// Who announces which universes, as it stands at `now`.
    std::vector<SacnDiscoveredSource> discovered(TimePoint now) const { return discovered_.status(now); }

    /// The universes that anybody announces at `now`, ascending.
    std::vector<std::uint16_t> announcedUniverses(TimePoint now) const { return discovered_.universes(now); }

    /// Universes that came by the multicast group of another one. They are taken all the same, since the
    /// packet names its universe; the sender is set up wrongly and other receivers will not hear it.
    const std::set<std::uint16_t>& universesOfWrongGroups() const { return wrongGroups_; }

 private:
    void takeData(const SacnData& data, const IpEndpoint& from, const IpEndpoint& to, TimePoint now,
                  UniverseMerger& merger);
    void takeOrdered(const SacnData& data, const SacnStreamKey& key, const IpEndpoint& from, TimePoint now,
                     UniverseMerger& merger);
    Verdict takeSlots(const SacnData& data, TimePoint now, UniverseMerger& merger);
    void takeSync(const SacnSync& sync, const IpEndpoint& from, TimePoint now, UniverseMerger& merger);
    void countRefusal(SacnRefusal refusal);
    bool isWanted(bool isPreview) const;

    PreviewRule preview_;
    SacnStreams streams_;
    SacnSyncTable sync_;
    SacnDiscoveredSources discovered_;
    std::set<std::uint16_t> wrongGroups_;
    SacnCounters counters_;
};

}  // namespace hazer::protocol
