#include "protocol/receiver.h"

#include <algorithm>
#include <asio/buffer.hpp>
#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>
#include <mutex>
#include <optional>
#include <random>
#include <thread>

#include "protocol/artnet_node.h"
#include "protocol/datagram_batch.h"
#include "protocol/udp.h"

namespace hazer::protocol {
namespace {

using asio::ip::udp;

// Asked for so that a stall of this thread loses no packets. Systems grant less by default (Linux:
// net.core.rmem_max).
constexpr int kReceiveBufferBytes = 8 << 20;

constexpr std::chrono::milliseconds kRetryAfterError{100};

ArtNetNodeConfig nodeConfigFrom(const ReceiverConfig& config) {
    return {.portAddresses = config.portAddresses,
            .shortName = config.shortName,
            .longName = config.longName,
            .maxPollReplyDelay = config.maxPollReplyDelay,
            .randomSeed = std::random_device{}(),
            .isProgrammable = config.isProgrammable};
}

Endpoint endpointFrom(const udp::endpoint& endpoint) {
    return {endpoint.address().to_v4().to_bytes(), endpoint.port()};
}

Endpoint ipv4From(const IpEndpoint& endpoint) {
    Endpoint ipv4;
    std::copy_n(endpoint.address.begin(), ipv4.address.size(), ipv4.address.begin());
    ipv4.port = endpoint.port;
    return ipv4;
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
    DatagramBatch::prepare(socket.native_handle(), false);
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
          tap(config.tap),
          deadlineTimer(context),
          retryTimer(context) {
        waitForDatagrams();
        thread = std::jthread([this] { context.run(); });
    }

    ~Impl() { context.stop(); }  // the thread, the last member, is joined first

    void waitForDatagrams() {
        socket.async_wait(udp::socket::wait_read, [this](const std::error_code& failure) {
            if (failure) return waitLater();
            takeDatagrams();
            waitForDatagrams();
        });
    }

    // One batch, then back to the loop: timers and the end of the program get their turn under any flood.
    void takeDatagrams() {
        const auto datagrams = batch.receive(socket.native_handle(), port);
        if (datagrams.empty()) return;
        if (tap) {
            for (const ArrivedDatagram& arrived : datagrams) tap(arrived.datagram);
        }
        store.change([&](UniverseMerger& merger) {
            const TimePoint now = Clock::now();
            for (const ArrivedDatagram& arrived : datagrams) {
                node.receive(arrived.datagram.bytes, ipv4From(arrived.datagram.from), now, merger);
            }
        });
        lostBefore = std::max(lostBefore, datagrams.back().lostBefore);
        publishStatus();
        scheduleDeadline();
    }

    // A network that goes away must not turn this thread into a busy loop.
    void waitLater() {
        retryTimer.expires_after(kRetryAfterError);
        retryTimer.async_wait([this](const std::error_code&) { waitForDatagrams(); });
    }

    void publishStatus() {
        const std::lock_guard lock(statusMutex);
        publishedStatus = node.status();
        publishedStatus.counters.droppedBySystem = lostBefore;
    }

    void scheduleDeadline() {
        const auto deadline = node.nextDeadline();
        if (!deadline || deadline == scheduled) return;
        scheduled = deadline;
        deadlineTimer.expires_at(*deadline);
        deadlineTimer.async_wait([this](const std::error_code& failure) {
            if (!failure) meetDeadline();
        });
    }

    void meetDeadline() {
        const TimePoint now = Clock::now();
        store.change([&](UniverseMerger& merger) {
            merger.expire(now);
            node.advance(now, merger);
        });
        while (const auto reply = node.takeDueReply(now)) send(*reply);
        publishStatus();
        scheduled.reset();
        scheduleDeadline();
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
    DatagramBatch batch;
    const DatagramTap tap;
    asio::steady_timer deadlineTimer;
    asio::steady_timer retryTimer;
    std::uint32_t lostBefore = 0;        // by the system, of datagrams that came too fast
    std::optional<TimePoint> scheduled;  // what deadlineTimer waits for
    mutable std::mutex statusMutex;
    ArtNetStatus publishedStatus;
    std::jthread thread;
};

Receiver::Receiver(ReceiverConfig config, UniverseStore& store)
    : impl_(std::make_unique<Impl>(config, store)) {}

Receiver::~Receiver() = default;

std::uint16_t Receiver::port() const {
    return impl_->port;
}

ReceiverCounters Receiver::counters() const {
    return status().counters;
}

ArtNetStatus Receiver::status() const {
    const std::lock_guard lock(impl_->statusMutex);
    return impl_->publishedStatus;
}

}  // namespace hazer::protocol
