// The control requests that make an FTDI chip a DMX input: 250 kbaud, 8 data bits, 2 stop bits (ANSI E1.11),
// and what it has heard told at once. FTDI publishes them as the functions of its D2XX library.
#pragma once

#include <cstdint>
#include <vector>

namespace hazer::protocol {

/// A vendor request to the device, without data.
struct UsbControlRequest {
    std::uint8_t request = 0;
    std::uint16_t value = 0;
    std::uint16_t index = 0;
    auto operator<=>(const UsbControlRequest&) const = default;
};

/// `bcdDevice` of the device descriptor names the chip. `port`: 0 for the first or only one of the chip.
/// The board's transmitter is switched off by RTS being low.
std::vector<UsbControlRequest> ftdiSetup(std::uint16_t bcdDevice, int port);

/// The index of requests to `port`.
std::uint16_t ftdiIndex(int port);

/// How many serial ports a chip of this product id has.
int ftdiPortCount(std::uint16_t productId);

}  // namespace hazer::protocol
