#include "protocol/sacn_membership.h"

namespace hazer::protocol {

std::set<SacnMembership> sacnMemberships(const std::vector<NetworkInterface>& interfaces,
                                         const std::string& chosen, const std::set<std::uint16_t>& numbers,
                                         bool usesIpv6) {
    const auto only = findInterface(interfaces, chosen);
    std::set<SacnMembership> wanted;
    for (const NetworkInterface& one : interfaces) {
        if (!chosen.empty() && (!only || one.index != only->index)) continue;
        if (!one.isRunning || one.isLoopback || !one.hasMulticast) continue;
        for (const std::uint16_t number : numbers) {
            if (one.hasAddress(false)) wanted.insert({one.index, false, number});
            if (usesIpv6 && one.hasAddress(true)) wanted.insert({one.index, true, number});
        }
    }
    return wanted;
}

}  // namespace hazer::protocol
