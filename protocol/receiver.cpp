#include "protocol/receiver.h"

#include <array>
#include <asio/buffer.hpp>
#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>
#include <mutex>
#include <random>
#include <thread>

#include "protocol/artnet_node.h"
#include "protocol/udp.h"

namespace hazer::protocol {
namespace {

using asio::ip::udp;

// Longer than any ArtDmx (530 bytes); the rest of a longer datagram is of no use to us and is cut off by the
// system.
constexpr std::size_t kMaxDatagramSize = 2048;

// Asked for so that a stall of this thread loses no packets. Systems grant less by default (Linux:
// net.core.rmem_max).
constexpr int kReceiveBufferBytes = 1 << 20;

constexpr std::chrono::milliseconds kRetryAfterError{100};

ArtNetNodeConfig nodeConfigFrom(const ReceiverConfig& config) {
    return {.portAddresses = config.portAddresses,
            .shortName = config.shortName,
            .longName = config.longName,
            .maxPollReplyDelay = config.maxPollReplyDelay,
            .randomSeed = std::random_device{}()};
}

Endpoint endpointFrom(const udp::endpoint& endpoint) {
    return {endpoint.address().to_v4().to_bytes(), endpoint.port()};
}

udp::endpoint udpEndpointFrom(const Endpoint& endpoint) {
    return {asio::ip::address_v4(endpoint.address), endpoint.port};
}

// SO_REUSEADDR lets hazer live beside another Art-Net program on this machine. Never SO_REUSEPORT: Linux then
// deals unicast packets out between the two.
udp::socket boundSocket(asio::io_context& context, const udp::endpoint& local) {
    udp::socket socket(context);
    std::error_code failure;
    socket.open(udp::v4(), failure);
    if (!failure) socket.set_option(udp::socket::reuse_address(true), failure);
    if (!failure) socket.bind(local, failure);
    if (!failure) socket.non_blocking(true, failure);
    if (failure) throwNetworkError("listen on", local, failure);
    std::error_code smallerBufferWillDo;
    socket.set_option(udp::socket::receive_buffer_size(kReceiveBufferBytes), smallerBufferWillDo);
    return socket;
}

}  // namespace

struct Receiver::Impl {
    Impl(const ReceiverConfig& config, UniverseStore& universeStore)
        : store(universeStore),
          node(nodeConfigFrom(config)),
          socket(boundSocket(context, udpEndpoint(config.address, config.port))),
          port(socket.local_endpoint().port()),
          replyTimer(context),
          retryTimer(context) {
        receiveNext();
        thread = std::jthread([this] { context.run(); });
    }

    ~Impl() { context.stop(); }  // the thread, the last member, is joined first

    void receiveNext() {
        socket.async_receive_from(asio::buffer(buffer), from,
                                  [this](const std::error_code& failure, std::size_t size) {
                                      if (failure) return retryLater();
                                      handle(std::span(buffer).first(size));
                                  });
    }

    void handle(std::span<const std::uint8_t> datagram) {
        store.change([&](UniverseMerger& merger) {
            node.receive(datagram, endpointFrom(from), Clock::now(), merger);
        });
        publishCounters();
        sendDueReplies();
        receiveNext();
    }

    // A network that goes away must not turn this thread into a busy loop.
    void retryLater() {
        retryTimer.expires_after(kRetryAfterError);
        retryTimer.async_wait([this](const std::error_code&) { receiveNext(); });
    }

    void publishCounters() {
        const std::lock_guard lock(countersMutex);
        publishedCounters = node.counters();
    }

    void sendDueReplies() {
        while (const auto reply = node.takeDueReply(Clock::now())) send(*reply);
        const auto due = node.nextReplyDue();
        if (!due) return;
        replyTimer.expires_at(*due);
        replyTimer.async_wait([this](const std::error_code& failure) {
            if (!failure) sendDueReplies();
        });
    }

    // A reply that cannot be sent is lost like any datagram; the desk polls again in a few seconds.
    void send(const PendingReply& reply) {
        const udp::endpoint to = udpEndpointFrom(reply.to);
        for (const auto& datagram : node.packReply(reply, ownAddressTowards(to))) {
            std::error_code lost;
            socket.send_to(asio::buffer(datagram), to, 0, lost);
        }
    }

    // A socket bound to 0.0.0.0 has no address to name. Connecting a UDP socket sends nothing, but makes the
    // system choose the address it would send from.
    Ipv4Address ownAddressTowards(const udp::endpoint& to) {
        udp::socket probe(context, udp::v4());
        std::error_code unreachable;
        probe.connect(to, unreachable);
        return endpointFrom((unreachable ? socket : probe).local_endpoint()).address;
    }

    asio::io_context context{1};
    UniverseStore& store;
    ArtNetNode node;
    udp::socket socket;
    const std::uint16_t port;  // read by others, who must not touch the socket
    asio::steady_timer replyTimer;
    asio::steady_timer retryTimer;
    std::array<std::uint8_t, kMaxDatagramSize> buffer{};
    udp::endpoint from;
    mutable std::mutex countersMutex;
    ReceiverCounters publishedCounters;
    std::jthread thread;
};

Receiver::Receiver(ReceiverConfig config, UniverseStore& store)
    : impl_(std::make_unique<Impl>(config, store)) {}

Receiver::~Receiver() = default;

std::uint16_t Receiver::port() const {
    return impl_->port;
}

ReceiverCounters Receiver::counters() const {
    const std::lock_guard lock(impl_->countersMutex);
    return impl_->publishedCounters;
}

}  // namespace hazer::protocol
