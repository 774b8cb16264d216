#include "protocol/udp.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <asio/error.hpp>

#include "protocol/network_error.h"
#include "protocol/network_interfaces.h"

namespace hazer::protocol {
namespace {

const char* remedyFor(const std::error_code& reason) {
    if (reason == asio::error::address_in_use) {
        return "close the program that keeps this port for itself, or choose another port";
    }
    if (reason.value() == static_cast<int>(std::errc::address_not_available)) {
        return "choose an address of this machine, or 0.0.0.0 for all of them";
    }
    if (reason == asio::error::access_denied)
        return "choose a port from 1024 up and an address you may send to";
    return "check the address and that the network is up";
}

}  // namespace

asio::ip::udp::endpoint udpEndpoint(const std::string& address, std::uint16_t port) {
    std::error_code failure;
    const auto parsed = asio::ip::make_address_v4(address, failure);
    if (failure) {
        throw NetworkError(fmt::format(
            "cannot use {}:{}: not an IPv4 address; write four numbers, such as 127.0.0.1", address, port));
    }
    return {parsed, port};
}

asio::ip::udp::endpoint anyUdpEndpoint(const std::string& address, std::uint16_t port) {
    std::error_code failure;
    const auto parsed = asio::ip::make_address(address, failure);
    if (failure) {
        throw NetworkError(
            fmt::format("cannot use {}:{}: not an IP address; write one such as 10.0.0.5 or fe80::1%eth0",
                        address, port));
    }
    return {parsed, port};
}

asio::ip::udp::endpoint udpEndpointFrom(const IpEndpoint& endpoint) {
    const auto& bytes = endpoint.address;
    if (endpoint.isIpv6) return {asio::ip::address_v6(bytes), endpoint.port};
    return {asio::ip::address_v4({bytes[0], bytes[1], bytes[2], bytes[3]}), endpoint.port};
}

void throwUnknownInterface(const std::string& nameOrAddress) {
    std::vector<std::string> names;
    for (const NetworkInterface& one : networkInterfaces()) names.push_back(one.name);
    throw NetworkError(fmt::format("cannot use the network interface '{}': this machine has {}",
                                   nameOrAddress, fmt::join(names, ", ")));
}

void throwNetworkError(const char* action, const asio::ip::udp::endpoint& endpoint,
                       const std::error_code& reason) {
    throw NetworkError(fmt::format("cannot {} {}:{}: {}; {}", action, endpoint.address().to_string(),
                                   endpoint.port(), reason.message(), remedyFor(reason)));
}

}  // namespace hazer::protocol
