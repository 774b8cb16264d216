#include "protocol/network_interfaces.h"

#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

#include <algorithm>
#include <asio/ip/address.hpp>
#include <cstring>
#include <map>
#include <memory>

namespace hazer::protocol {
namespace {

std::optional<IpEndpoint> endpointOf(const sockaddr* address) {
    IpEndpoint endpoint;
    if (address && address->sa_family == AF_INET) {
        sockaddr_in v4{};
        std::memcpy(&v4, address, sizeof v4);
        std::memcpy(endpoint.address.data(), &v4.sin_addr, sizeof v4.sin_addr);
        return endpoint;
    }
    if (address && address->sa_family == AF_INET6) {
        sockaddr_in6 v6{};
        std::memcpy(&v6, address, sizeof v6);
        std::memcpy(endpoint.address.data(), &v6.sin6_addr, sizeof v6.sin6_addr);
        endpoint.isIpv6 = true;
        return endpoint;
    }
    return std::nullopt;
}

std::optional<IpEndpoint> parseAddress(const std::string& text) {
    std::error_code failure;
    const asio::ip::address parsed = asio::ip::make_address(text, failure);
    if (failure) return std::nullopt;
    IpEndpoint endpoint;
    endpoint.isIpv6 = parsed.is_v6();
    if (parsed.is_v6()) {
        endpoint.address = parsed.to_v6().to_bytes();
    } else {
        std::ranges::copy(parsed.to_v4().to_bytes(), endpoint.address.begin());
    }
    return endpoint;
}

// The whole of 127.0.0.0/8 is loopback's, though it lists one address.
bool isOf(const NetworkInterface& interface, const IpEndpoint& address) {
    if (interface.isLoopback && !address.isIpv6 && address.address[0] == 127) return true;
    return std::ranges::find(interface.addresses, address) != interface.addresses.end();
}

}  // namespace

bool NetworkInterface::hasAddress(bool isIpv6) const {
    return std::ranges::find(addresses, isIpv6, &IpEndpoint::isIpv6) != addresses.end();
}

std::vector<NetworkInterface> networkInterfaces() {
    ifaddrs* first = nullptr;
    if (getifaddrs(&first) != 0) return {};
    const std::unique_ptr<ifaddrs, decltype(&freeifaddrs)> owner(first, &freeifaddrs);
    std::map<unsigned, NetworkInterface> byIndex;
    for (const ifaddrs* one = first; one; one = one->ifa_next) {
        const unsigned index = if_nametoindex(one->ifa_name);
        if (index == 0) continue;  // it vanished in between
        NetworkInterface& interface = byIndex[index];
        interface.name = one->ifa_name;
        interface.index = index;
        interface.isRunning = (one->ifa_flags & IFF_UP) && (one->ifa_flags & IFF_RUNNING);
        interface.isLoopback = one->ifa_flags & IFF_LOOPBACK;
        interface.hasMulticast = one->ifa_flags & IFF_MULTICAST;
        if (const auto address = endpointOf(one->ifa_addr)) interface.addresses.push_back(*address);
    }
    std::vector<NetworkInterface> all;
    for (auto& [index, interface] : byIndex) all.push_back(std::move(interface));
    return all;
}

std::optional<NetworkInterface> findInterface(const std::vector<NetworkInterface>& all,
                                              const std::string& nameOrAddress) {
    const auto named = std::ranges::find(all, nameOrAddress, &NetworkInterface::name);
    if (named != all.end()) return *named;
    const auto address = parseAddress(nameOrAddress);
    if (!address) return std::nullopt;
    const auto owner =
        std::ranges::find_if(all, [&](const NetworkInterface& one) { return isOf(one, *address); });
    return owner == all.end() ? std::nullopt : std::optional(*owner);
}

}  // namespace hazer::protocol
