// What a recording is given of USB, which has no datagrams.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "protocol/datagram.h"
#include "protocol/dmx.h"

namespace hazer::protocol {

/// Called on the receiving thread with the 0..512 slots of every frame. Must not wait.
using UsbTap = std::function<void(UniverseId universe, std::span<const std::uint8_t> slots, WallTime time)>;

}  // namespace hazer::protocol
