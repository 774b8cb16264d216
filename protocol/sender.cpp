#include "protocol/sender.h"

#include <asio/buffer.hpp>
#include <asio/io_context.hpp>
#include <map>

#include "protocol/artnet.h"
#include "protocol/udp.h"

namespace hazer::protocol {
namespace {

// 0 is left out: it would say that the packets have no order.
std::uint8_t nextSequence(std::uint8_t last) {
    return last == 255 ? 1 : static_cast<std::uint8_t>(last + 1);
}

}  // namespace

struct ArtNetSender::Impl {
    explicit Impl(const asio::ip::udp::endpoint& to) : destination(to) {}

    void open() {
        std::error_code failure;
        socket.open(asio::ip::udp::v4(), failure);
        if (!failure) socket.set_option(asio::socket_base::broadcast(true), failure);
        if (failure) throwNetworkError("send to", destination, failure);
    }

    void send(std::span<const std::uint8_t> datagram) {
        std::error_code failure;
        socket.send_to(asio::buffer(datagram.data(), datagram.size()), destination, 0, failure);
        if (failure) throwNetworkError("send to", destination, failure);
    }

    asio::io_context context;
    asio::ip::udp::socket socket{context};
    asio::ip::udp::endpoint destination;
    std::map<std::uint16_t, std::uint8_t> lastSequences;
};

ArtNetSender::ArtNetSender(const std::string& address, std::uint16_t port)
    : impl_(std::make_unique<Impl>(udpEndpoint(address, port))) {
    impl_->open();
}

ArtNetSender::~ArtNetSender() = default;

void ArtNetSender::send(std::uint16_t portAddress, std::span<const std::uint8_t> slots) {
    std::uint8_t& sequence = impl_->lastSequences[portAddress];
    sequence = nextSequence(sequence);
    impl_->send(packArtDmx(portAddress, sequence, slots));
}

void ArtNetSender::sendSync() {
    impl_->send(packArtSync());
}

}  // namespace hazer::protocol
