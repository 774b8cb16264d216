// Who says to send which sACN universes (ANSI E1.31-2018, sections 4.3 and 8).
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "protocol/deep_ptr.h"
#include "protocol/dmx.h"
#include "protocol/endpoint.h"
#include "protocol/sacn.h"

namespace hazer::protocol {

/// A source that announces itself.
struct SacnDiscoveredSource {
    Cid cid{};
    std::string name;                      ///< Printable.
    std::string address;                   ///< Without the port.
    std::vector<std::uint16_t> universes;  ///< Of the last whole list, ascending, 1..63999.
    TimePoint lastSeen{};
};

/// The sources that have announced themselves of late. Bounded; for display alone. Not thread-safe.
class SacnDiscoveredSources {
 public:
    static constexpr std::size_t kCapacity = 256;

    /// Two intervals of E131_UNIVERSE_DISCOVERY_INTERVAL.
    static constexpr std::chrono::seconds kForgetAfter{20};

    /// One page. A list counts when all of its pages have come, in order; else the earlier list stands.
    /// False: all places are taken by sources that are alive.
    bool take(const SacnDiscovery& page, const IpEndpoint& from, TimePoint now);

    /// Those seen within kForgetAfter, ascending by CID.
    std::vector<SacnDiscoveredSource> status(TimePoint now) const;

    /// The universes of all of those, each once, ascending.
    std::vector<std::uint16_t> universes(TimePoint now) const;

 private:
    /// A bit for each universe, in words, so that a display may ask for all of them often.
    using UniverseBits = std::array<std::uint64_t, kMaxSacnUniverse / 64 + 1>;

    static std::vector<std::uint16_t> listOf(const UniverseBits& bits);

    struct Source {
        std::string name;
        IpEndpoint from{};
        TimePoint lastSeen{};
        UniverseBits universes{};  ///< Of the last whole list.
        UniverseBits collected{};  ///< Of the pages so far.
        unsigned nextPage = 0;
    };

    bool makeRoom(TimePoint now);

    std::map<Cid, DeepPtr<Source>> sources_;
};

}  // namespace hazer::protocol
