// The network interfaces of this machine, for multicast.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "protocol/endpoint.h"

namespace hazer::protocol {

struct NetworkInterface {
    std::string name;        ///< "eth0".
    unsigned index = 0;      ///< The system's number of it, from 1.
    bool isRunning = false;  ///< Switched on, and its cable or radio is connected.
    bool isLoopback = false;
    bool hasMulticast = false;
    std::vector<IpEndpoint> addresses;  ///< IPv4 and IPv6; port 0.

    bool hasAddress(bool isIpv6) const;
};

/// Those there are now, ascending by index; empty if the system does not tell.
std::vector<NetworkInterface> networkInterfaces();

/// The interface of that name, or with that IPv4 or IPv6 address; 127.x.y.z is loopback's.
std::optional<NetworkInterface> findInterface(const std::vector<NetworkInterface>& all,
                                              const std::string& nameOrAddress);

}  // namespace hazer::protocol
