// A datagram on its way, as a recording keeps it.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <span>

#include "protocol/endpoint.h"

namespace hazer::protocol {

/// Time since 1970-01-01 UTC, to the nanosecond, as recordings write it.
using WallTime = std::chrono::sys_time<std::chrono::nanoseconds>;

struct Datagram {
    IpEndpoint from{};
    IpEndpoint to{};  ///< Where it arrived: our own address and port, or the multicast group.
    WallTime time{};
    std::span<const std::uint8_t> bytes{};
};

/// Called on the receiving thread with everything that arrives, before it is parsed. Must not wait.
using DatagramTap = std::function<void(const Datagram&)>;

}  // namespace hazer::protocol
