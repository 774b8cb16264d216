// The packets of Art-Net 4 as pure functions of bytes: levels here, the others in artnet_poll.h (who is
// there) and artnet_control.h (remote programming, time code, triggers). Source: "Art-Net 4 Protocol
// Release", Artistic Licence; the sections named below are its packet definitions. docs/artnet.md tells what
// hazer does with them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "protocol/artnet_control.h"
#include "protocol/artnet_poll.h"
#include "protocol/dmx.h"

namespace hazer::protocol {

/// The UDP port of Art-Net, both ends (0x1936).
inline constexpr std::uint16_t kArtNetPort = 6454;

/// Levels for one universe (section ArtDmx).
struct ArtDmx {
    std::uint8_t sequence = 0;            ///< 1..255, or 0: the sender does not number its packets.
    std::uint8_t physical = 0;            ///< The sender's DMX input. Tells two inputs of one sender apart.
    std::uint16_t portAddress = 0;        ///< 0..32767.
    std::span<const std::uint8_t> slots;  ///< 1..512 values, inside the datagram that was parsed.
};

/// Values with another start code than 0, which are no levels (section ArtNzs).
struct ArtNzs {
    std::uint8_t sequence = 0;
    std::uint8_t startCode = 0;           ///< Neither 0 nor that of RDM (0xCC).
    std::uint16_t portAddress = 0;        ///< 0..32767.
    std::span<const std::uint8_t> slots;  ///< 1..512 values, inside the datagram that was parsed.
};

/// All nodes show at once what came since the last one (section ArtSync).
struct ArtSync {};

/// Why a datagram is none of the packets we know.
enum class Refusal : std::uint8_t {
    kNotArtNet,     ///< Does not begin with the Art-Net identifier.
    kTruncated,     ///< Ends inside its header.
    kOldVersion,    ///< Protocol version below 14.
    kBadValue,      ///< A field has a value that its section forbids.
    kNoSlots,       ///< ArtDmx or ArtNzs without a single slot.
    kUnusedOpCode,  ///< Art-Net, but of a kind that we do not use.
};

using ArtNetPacket = std::variant<ArtDmx, ArtNzs, ArtSync, ArtPoll, PeerPollReply, ArtDiagData, ArtAddress,
                                  ArtIpProg, ArtTimeCode, ArtTrigger, Refusal>;

/// Parses one datagram of any length. Never throws, never reads outside `datagram`; spans and texts of the
/// packet refer into it.
ArtNetPacket parseArtNet(std::span<const std::uint8_t> datagram);

/// An ArtDmx datagram. `slots` holds 1..512 values; an odd count is padded with a 0 because the standard
/// wants it even. portAddress 0..32767; sequence 1..255, or 0 for packets without an order.
std::vector<std::uint8_t> packArtDmx(std::uint16_t portAddress, std::uint8_t sequence,
                                     std::span<const std::uint8_t> slots, std::uint8_t physical = 0);

inline constexpr std::size_t kArtSyncSize = 14;
std::array<std::uint8_t, kArtSyncSize> packArtSync();

}  // namespace hazer::protocol
