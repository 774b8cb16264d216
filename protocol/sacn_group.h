// The multicast groups that sACN sends to (ANSI E1.31-2018, section 9.3).
#pragma once

#include <cstdint>

#include "protocol/endpoint.h"

namespace hazer::protocol {

/// 239.255.H.L of a universe, of a synchronization address, or of universe discovery.
IpEndpoint sacnGroupV4(std::uint16_t universe, std::uint16_t port);

/// ff18::8300:HHLL of the same.
IpEndpoint sacnGroupV6(std::uint16_t universe, std::uint16_t port);

bool isMulticast(const IpEndpoint& endpoint);

/// Whether `to` is a multicast group, but not that of `universe`. Unicast and broadcast never are.
bool isWrongGroup(const IpEndpoint& to, std::uint16_t universe);

}  // namespace hazer::protocol
