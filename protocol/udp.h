// What the sender and the receiver share of Asio. Only for .cpp files of this module: Asio does not reach its
// interfaces.
#pragma once

#include <asio/ip/udp.hpp>
#include <string>
#include <system_error>

namespace hazer::protocol {

/// A dotted IPv4 address as an Asio endpoint. Throws NetworkError if it is anything else.
asio::ip::udp::endpoint udpEndpoint(const std::string& address, std::uint16_t port);

/// Throws NetworkError with one sentence: "cannot <action> <address>:<port>: <reason>; <remedy>".
[[noreturn]] void throwNetworkError(const char* action, const asio::ip::udp::endpoint& endpoint,
                                    const std::error_code& reason);

}  // namespace hazer::protocol
