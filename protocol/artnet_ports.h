// The Port-Addresses of our node, as the show patches them and as the network knows them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "protocol/artnet.h"
#include "protocol/universe_merger.h"

namespace hazer::protocol {

struct ArtNetPort {
    std::uint16_t patched = 0;  ///< Under which its levels stand in the merger, and in the show.
    std::uint16_t onWire = 0;   ///< The same unless a desk has given it another with ArtAddress.
    bool isReceiving = false;   ///< As it was last announced, like the next two.
    bool isMerging = false;
    MergeMode mode = MergeMode::kHighest;
};

/// What of a port has changed.
struct ArtNetPortChange {
    std::uint16_t onWire = 0;
    bool isMergingNow = false;
    bool hasMergingChanged = false;
};

class ArtNetPorts {
 public:
    /// Repeated Port-Addresses count once.
    explicit ArtNetPorts(std::vector<std::uint16_t> portAddresses);

    const std::vector<ArtNetPort>& all() const { return ports_; }

    /// The port that a desk means by a BindIndex: 0 and 1 the first. Null if there is none.
    ArtNetPort* atBindIndex(std::uint8_t bindIndex);

    /// Under which number levels for this Port-Address stand. Nothing if it was the address of a port that
    /// has moved away.
    std::optional<std::uint16_t> universeOf(std::uint16_t onWire) const;

    /// Sets the address of a port as the switches of an ArtAddress say. Returns whether it changed.
    bool program(ArtNetPort& port, const ArtAddress& address);

    /// Compares one port with what the merger says now, and remembers that. Nothing if nothing changed.
    std::optional<ArtNetPortChange> update(std::size_t index, UniverseMerger& merger, TimePoint now);

 private:
    std::vector<ArtNetPort> ports_;  ///< Ascending as patched.
    bool hasMoved_ = false;
};

}  // namespace hazer::protocol
