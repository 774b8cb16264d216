// Which multicast groups sACN is to be heard from, and by which interfaces.
#pragma once

#include <compare>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "protocol/network_interfaces.h"

namespace hazer::protocol {

/// One group at one interface.
struct SacnMembership {
    unsigned interfaceIndex = 0;
    bool isIpv6 = false;
    std::uint16_t number = 0;  ///< Universe, synchronization address or discovery universe.
    auto operator<=>(const SacnMembership&) const = default;
};

/// The memberships wanted: every number at every interface that is running, is not loopback, takes multicast
/// and has an address of that version of IP. `chosen`: the name or an address of the only interface to use;
/// empty: all. An interface that is not there, or whose cable is out, gives none: when it comes back, its
/// groups are joined anew, which tells the switch.
std::set<SacnMembership> sacnMemberships(const std::vector<NetworkInterface>& interfaces,
                                         const std::string& chosen, const std::set<std::uint16_t>& numbers,
                                         bool usesIpv6);

}  // namespace hazer::protocol
