// The packets of Art-Net 4 as pure functions of bytes. Source: "Art-Net 4 Protocol Release", Artistic
// Licence; the sections named below are its packet definitions. docs/protocols.md tells what hazer does with
// them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "protocol/dmx.h"
#include "protocol/endpoint.h"

namespace hazer::protocol {

/// The UDP port of Art-Net, both ends (0x1936).
inline constexpr std::uint16_t kArtNetPort = 6454;

/// The highest Port-Address: 7 bits Net, 4 bits Sub-Net, 4 bits Universe.
inline constexpr std::uint16_t kMaxPortAddress = 0x7FFF;

/// Levels for one universe (section ArtDmx).
struct ArtDmx {
    std::uint8_t sequence = 0;            ///< 1..255, or 0: the sender does not number its packets.
    std::uint8_t physical = 0;            ///< The sender's DMX input. Tells two inputs of one sender apart.
    std::uint16_t portAddress = 0;        ///< 0..32767.
    std::span<const std::uint8_t> slots;  ///< 1..512 values, inside the datagram that was parsed.
};

/// Port-Addresses first..last, both included.
struct PortAddressRange {
    std::uint16_t first = 0;
    std::uint16_t last = kMaxPortAddress;
    bool contains(std::uint16_t portAddress) const { return first <= portAddress && portAddress <= last; }
};

/// A desk asks who is there (section ArtPoll).
struct ArtPoll {
    /// Only nodes with a Port-Address in here are asked (targeted mode). Absent: every node.
    std::optional<PortAddressRange> target;
};

/// Why a datagram is neither of the packets we use.
enum class Refusal : std::uint8_t {
    kNotArtNet,     ///< Does not begin with the Art-Net identifier.
    kTruncated,     ///< Ends inside its header.
    kOldVersion,    ///< Protocol version below 14.
    kNoSlots,       ///< ArtDmx without a single slot.
    kUnusedOpCode,  ///< Art-Net, but of a kind that we do not use.
};

using ArtNetPacket = std::variant<ArtDmx, ArtPoll, Refusal>;

/// Parses one datagram of any length. Never throws, never reads outside `datagram`; an ArtDmx refers into it.
ArtNetPacket parseArtNet(std::span<const std::uint8_t> datagram);

/// An ArtDmx datagram. `slots` holds 1..512 values; an odd count is padded with a 0 because the standard
/// wants it even. portAddress 0..32767; sequence 1..255, or 0 for packets without an order.
std::vector<std::uint8_t> packArtDmx(std::uint16_t portAddress, std::uint8_t sequence,
                                     std::span<const std::uint8_t> slots);

inline constexpr std::size_t kArtPollReplySize = 239;
using ArtPollReplyBytes = std::array<std::uint8_t, kArtPollReplySize>;

/// What we tell a desk about ourselves (section ArtPollReply): one Port-Address a reply, as Art-Net 4
/// prefers.
struct ArtPollReply {
    Ipv4Address ownAddress{};  ///< Our address on the network of the desk.
    /// The Port-Address we ask for, 0..32767. Absent: a node without ports.
    std::optional<std::uint16_t> portAddress{};
    std::uint8_t bindIndex = 1;     ///< 1 for the first reply of a node, then 2, 3 ...
    std::string_view shortName{};   ///< At most 17 characters reach the wire.
    std::string_view longName{};    ///< At most 63 characters reach the wire.
    std::string_view nodeReport{};  ///< "#xxxx [yyyy] text". At most 63 characters reach the wire.
};

/// An ArtPollReply datagram of a visualizer that turns Art-Net into light.
ArtPollReplyBytes packArtPollReply(const ArtPollReply& reply);

}  // namespace hazer::protocol
