// UDP as a stranger would send it.
#pragma once

#include <cstdint>
#include <string_view>

namespace hazer::test {

/// Sends one datagram, possibly empty, to 127.0.0.1.
void sendDatagram(std::uint16_t port, std::string_view bytes);

/// Holds a UDP port on all interfaces so that nobody else can bind it.
class OccupiedPort {
 public:
    OccupiedPort();
    ~OccupiedPort();
    OccupiedPort(const OccupiedPort&) = delete;
    OccupiedPort& operator=(const OccupiedPort&) = delete;

    std::uint16_t port() const { return port_; }

 private:
    int socket_;
    std::uint16_t port_;
};

}  // namespace hazer::test
