// Who is at the other end of the wire, without a word of sockets.
#pragma once

#include <array>
#include <compare>
#include <cstdint>

namespace hazer::protocol {

/// An IPv4 address, most significant byte first: {127, 0, 0, 1}.
using Ipv4Address = std::array<std::uint8_t, 4>;

/// A UDP port at an address.
struct Endpoint {
    Ipv4Address address{};
    std::uint16_t port = 0;
    auto operator<=>(const Endpoint&) const = default;
};

/// The same for either version of IP.
struct IpEndpoint {
    std::array<std::uint8_t, 16> address{};  ///< Most significant byte first; IPv4: the first four, then 0.
    bool isIpv6 = false;
    std::uint16_t port = 0;
    auto operator<=>(const IpEndpoint&) const = default;
};

}  // namespace hazer::protocol
