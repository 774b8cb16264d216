#include "protocol/udp.h"

#include <fmt/format.h>

#include <asio/error.hpp>

#include "protocol/network_error.h"

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

void throwNetworkError(const char* action, const asio::ip::udp::endpoint& endpoint,
                       const std::error_code& reason) {
    throw NetworkError(fmt::format("cannot {} {}:{}: {}; {}", action, endpoint.address().to_string(),
                                   endpoint.port(), reason.message(), remedyFor(reason)));
}

}  // namespace hazer::protocol
