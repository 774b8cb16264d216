// Takes what a network card adds off a captured frame.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace hazer::protocol {

/// Whether captures of this link type (a DLT of libpcap) can be read.
bool isKnownLinkType(int linkType);

/// The IP packet within a captured frame: Ethernet with any number of VLAN tags up to 4 (802.1Q, 802.1ad),
/// Linux cooked (v1, v2), loopback, raw IP. Nothing if the frame holds something else or is too short.
std::optional<std::span<const std::uint8_t>> ipPacketOf(int linkType, std::span<const std::uint8_t> frame);

}  // namespace hazer::protocol
