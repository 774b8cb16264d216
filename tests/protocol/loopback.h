// A UDP socket of a desk or of another program, and bounded waits, for tests over loopback.
#pragma once

#include <asio/io_context.hpp>
#include <asio/ip/udp.hpp>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace hazer::protocol::test {

/// Long enough for any machine; a test that passes does not wait for it.
inline constexpr std::chrono::seconds kPatience{10};

/// Whether `condition` came true before patience ran out.
bool comesTrue(const std::function<bool()>& condition);

/// Bound to 127.0.0.1 and a port of the system's choice, without SO_REUSEADDR: nobody else can have that
/// port.
class LoopbackSocket {
 public:
    LoopbackSocket();

    std::uint16_t port() const;
    void sendTo(std::uint16_t port, std::span<const std::uint8_t> datagram);

    /// The next datagram, or nothing if patience runs out.
    std::optional<std::vector<std::uint8_t>> receive();

 private:
    asio::io_context context_;
    asio::ip::udp::socket socket_;
};

}  // namespace hazer::protocol::test
