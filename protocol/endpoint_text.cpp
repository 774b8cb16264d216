#include "protocol/endpoint_text.h"

#include <asio/ip/address.hpp>

namespace hazer::protocol {

std::string addressText(const IpEndpoint& endpoint) {
    if (endpoint.isIpv6) return asio::ip::address_v6(endpoint.address).to_string();
    const auto& bytes = endpoint.address;
    return asio::ip::address_v4({bytes[0], bytes[1], bytes[2], bytes[3]}).to_string();
}

}  // namespace hazer::protocol
