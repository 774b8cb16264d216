// What the sender and the receiver share of Asio. Only for .cpp files of this module: Asio does not reach its
// interfaces.
#pragma once

#include <asio/ip/udp.hpp>
#include <string>
#include <system_error>

#include "protocol/endpoint.h"

namespace hazer::protocol {

/// A dotted IPv4 address as an Asio endpoint. Throws NetworkError if it is anything else.
asio::ip::udp::endpoint udpEndpoint(const std::string& address, std::uint16_t port);

/// The same for either version of IP: "10.0.0.5", "fe80::1%eth0".
asio::ip::udp::endpoint anyUdpEndpoint(const std::string& address, std::uint16_t port);

asio::ip::udp::endpoint udpEndpointFrom(const IpEndpoint& endpoint);

/// Throws NetworkError with one sentence that names the interfaces there are.
[[noreturn]] void throwUnknownInterface(const std::string& nameOrAddress);

/// Throws NetworkError with one sentence: "cannot <action> <address>:<port>: <reason>; <remedy>".
[[noreturn]] void throwNetworkError(const char* action, const asio::ip::udp::endpoint& endpoint,
                                    const std::error_code& reason);

}  // namespace hazer::protocol
