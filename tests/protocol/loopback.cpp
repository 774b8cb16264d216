#include "tests/protocol/loopback.h"

#include <asio/buffer.hpp>
#include <thread>

namespace hazer::protocol::test {

using asio::ip::udp;

bool comesTrue(const std::function<bool()>& condition) {
    const auto deadline = std::chrono::steady_clock::now() + kPatience;
    while (!condition()) {
        if (std::chrono::steady_clock::now() > deadline) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
}

LoopbackSocket::LoopbackSocket() : socket_(context_, udp::endpoint(asio::ip::address_v4::loopback(), 0)) {
    socket_.non_blocking(true);
}

std::uint16_t LoopbackSocket::port() const {
    return socket_.local_endpoint().port();
}

void LoopbackSocket::sendTo(std::uint16_t port, std::span<const std::uint8_t> datagram) {
    const udp::endpoint to(asio::ip::address_v4::loopback(), port);
    socket_.send_to(asio::buffer(datagram.data(), datagram.size()), to);
}

std::optional<std::vector<std::uint8_t>> LoopbackSocket::receive() {
    std::vector<std::uint8_t> datagram(2048);
    std::size_t size = 0;
    const bool arrived = comesTrue([&] {
        std::error_code notYet;
        size = socket_.receive(asio::buffer(datagram), 0, notYet);
        return !notYet;
    });
    if (!arrived) return std::nullopt;
    datagram.resize(size);
    return datagram;
}

}  // namespace hazer::protocol::test
