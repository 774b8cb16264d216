// Which numbered series a packet of lighting belongs to, and where in it the number stands.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "protocol/dmx.h"
#include "protocol/endpoint.h"

namespace hazer::protocol {

struct PacketStream {
    Transport transport = Transport::kArtNet;
    bool isSync = false;                    ///< sACN: numbers its synchronization packets apart.
    std::array<std::uint8_t, 16> source{};  ///< sACN: the CID. Art-Net: address, port, Physical.
    std::uint16_t number = 0;               ///< Universe or synchronization address.
    auto operator<=>(const PacketStream&) const = default;
};

struct StreamedPacket {
    PacketStream stream{};
    std::size_t sequenceOffset = 0;  ///< Of the byte with the number.
    std::uint8_t startCode = 0;
    bool holdsLevels = false;  ///< It says what stands on a universe until the next one.
    bool ends = false;         ///< sACN: Stream_Terminated.
};

/// Nothing for packets that belong to none, such as polls.
std::optional<StreamedPacket> streamOf(std::span<const std::uint8_t> datagram, const IpEndpoint& from);

}  // namespace hazer::protocol
