// How desks and nodes find each other in Art-Net 4, and what nodes have to tell. See artnet.h.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "protocol/endpoint.h"

namespace hazer::protocol {

/// The highest Port-Address: 7 bits Net, 4 bits Sub-Net, 4 bits Universe.
inline constexpr std::uint16_t kMaxPortAddress = 0x7FFF;

/// Port-Addresses first..last, both included.
struct PortAddressRange {
    std::uint16_t first = 0;
    std::uint16_t last = kMaxPortAddress;
    bool contains(std::uint16_t portAddress) const { return first <= portAddress && portAddress <= last; }
};

/// How urgent a message of a node is (table "Priority Codes"). Others between are possible on the wire.
inline constexpr std::uint8_t kDiagLow = 0x10;
inline constexpr std::uint8_t kDiagMedium = 0x40;

/// A desk asks who is there (section ArtPoll).
struct ArtPoll {
    bool wantsChanges = false;      ///< A reply whenever something changes.
    bool wantsDiagnostics = false;  ///< ArtDiagData.
    std::uint8_t diagPriority = 0;  ///< The lowest that is wanted, kDiagLow and its kin.
    /// Only nodes with a Port-Address in here are asked (targeted mode). Absent: every node.
    std::optional<PortAddressRange> target{};
};

inline constexpr std::size_t kArtPollSize = 22;
std::array<std::uint8_t, kArtPollSize> packArtPoll(const ArtPoll& poll);

/// What the indicators of a node show (Status1, bits 7 and 6).
enum class Indicators : std::uint8_t { kLocate = 1, kMute = 2, kNormal = 3 };

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
    Indicators indicators = Indicators::kNormal;
    bool isProgrammable = false;  ///< The network may set our addresses.
    bool isReceiving = false;     ///< Levels arrive for the Port-Address.
    bool isMerging = false;
    bool mergesLatest = false;  ///< LTP, else HTP.
};

/// An ArtPollReply datagram of a visualizer that turns Art-Net into light.
ArtPollReplyBytes packArtPollReply(const ArtPollReply& reply);

/// What another node or a desk says of itself. Fields that older editions lack are 0.
struct PeerPollReply {
    Ipv4Address address{};
    std::string_view shortName{};  ///< Inside the datagram; any bytes but NUL.
    std::string_view longName{};   ///< The same.
    std::uint8_t style = 0;        ///< 0 node, 1 controller, 6 visualizer.
    std::uint8_t bindIndex = 0;    ///< 0 or 1: the root of a device.
    /// Port-Addresses that it wants to be sent; absent where a port is none of the kind.
    std::array<std::optional<std::uint16_t>, 4> wanted{};
};

/// A message of a node for people (section ArtDiagData).
struct ArtDiagData {
    std::uint8_t priority = kDiagLow;
    std::uint8_t logicalPort = 0;
    std::string_view text{};  ///< Inside the datagram, without its NUL.
};

/// At most 511 characters of the text reach the wire.
std::vector<std::uint8_t> packArtDiagData(const ArtDiagData& message);

}  // namespace hazer::protocol
