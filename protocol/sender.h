// Sends ArtDmx and ArtSync over UDP.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "protocol/dmx.h"

namespace hazer::protocol {

/// Sends to one address. Keeps a sequence of its own per Port-Address, 1..255. Not thread-safe.
class ArtNetSender {
 public:
    /// Throws NetworkError if the address is not an IPv4 address or the socket cannot be opened. Broadcast
    /// addresses are allowed; port 1..65535.
    ArtNetSender(const std::string& address, std::uint16_t port = 6454);
    ~ArtNetSender();
    ArtNetSender(const ArtNetSender&) = delete;
    ArtNetSender& operator=(const ArtNetSender&) = delete;

    /// Sends 1..512 slots (an odd count is padded with a 0, as Art-Net asks). Port-Address 0..32767.
    /// Throws NetworkError if the system cannot send there, as when no network leads to the address.
    void send(std::uint16_t portAddress, std::span<const std::uint8_t> slots);

    /// Sends an ArtSync: receivers show what they hold back of ours, all at once. Throws NetworkError as
    /// send().
    void sendSync();

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace hazer::protocol
