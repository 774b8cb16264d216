#include "protocol/sacn_sender.h"

#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <asio/buffer.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/multicast.hpp>

#include "protocol/network_error.h"
#include "protocol/network_interfaces.h"
#include "protocol/sacn_group.h"
#include "protocol/udp.h"

namespace hazer::protocol {
namespace {

using asio::ip::udp;

// Across the switches and a router or two of a venue, and not out into the world.
constexpr int kMulticastHops = 8;

SacnSenderConfig completed(SacnSenderConfig config) {
    if (config.source.cid == Cid{}) config.source.cid = randomCid();
    return config;
}

NetworkInterface interfaceOf(const std::string& nameOrAddress) {
    const auto found = findInterface(networkInterfaces(), nameOrAddress);
    if (!found) throwUnknownInterface(nameOrAddress);
    return *found;
}

udp::endpoint groupOf(std::uint16_t number, const SacnSenderConfig& config) {
    return udpEndpointFrom(config.usesIpv6Groups ? sacnGroupV6(number, config.port)
                                                 : sacnGroupV4(number, config.port));
}

// Asio can name the interface of IPv4 by an address only, which an interface need not have.
std::error_code chooseInterface(udp::socket& socket, unsigned index, bool isIpv6) {
    int failure = 0;
    if (isIpv6) {
        const int number = static_cast<int>(index);
        failure = setsockopt(socket.native_handle(), IPPROTO_IPV6, IPV6_MULTICAST_IF, &number, sizeof number);
    } else {
        ip_mreqn request{};
        request.imr_ifindex = static_cast<int>(index);
        failure = setsockopt(socket.native_handle(), IPPROTO_IP, IP_MULTICAST_IF, &request, sizeof request);
    }
    return failure == 0 ? std::error_code() : std::error_code(errno, std::system_category());
}

}  // namespace

struct SacnSender::Impl {
    explicit Impl(const SacnSenderConfig& wanted)
        : config(completed(wanted)), source(config.source), anyDestination(destination(1)) {
        std::error_code failure;
        socket.open(anyDestination.protocol(), failure);
        if (!failure && isMulticast()) socket.set_option(asio::ip::multicast::hops(kMulticastHops), failure);
        if (!failure && isMulticast() && !config.interface.empty()) {
            failure = chooseInterface(socket, interfaceOf(config.interface).index, config.usesIpv6Groups);
        }
        if (!failure) socket.set_option(asio::socket_base::broadcast(true), failure);
        if (failure) throwNetworkError("send to", anyDestination, failure);
    }

    bool isMulticast() const { return config.to.empty(); }

    udp::endpoint destination(std::uint16_t number) const {
        return isMulticast() ? groupOf(number, config) : anyUdpEndpoint(config.to, config.port);
    }

    void send(std::uint16_t number, std::span<const std::uint8_t> datagram) {
        const udp::endpoint to = isMulticast() ? groupOf(number, config) : anyDestination;
        std::error_code failure;
        socket.send_to(asio::buffer(datagram.data(), datagram.size()), to, 0, failure);
        if (failure) throwNetworkError("send to", to, failure);
        ++packetCount;
    }

    SacnSource::Emit emit() {
        return
            [this](std::uint16_t number, std::span<const std::uint8_t> datagram) { send(number, datagram); };
    }

    const SacnSenderConfig config;
    SacnSource source;
    asio::io_context context;
    udp::socket socket{context};
    const udp::endpoint anyDestination;  ///< Where unicast goes; of multicast, universe 1's group.
    std::uint64_t packetCount = 0;
};

SacnSender::SacnSender(SacnSenderConfig config) : impl_(std::make_unique<Impl>(config)) {}

SacnSender::~SacnSender() {
    try {
        terminate();
    } catch (const NetworkError&) {
        // The network is gone; receivers notice by themselves.
    }
}

const Cid& SacnSender::cid() const {
    return impl_->config.source.cid;
}

void SacnSender::setLevels(std::uint16_t universe, std::span<const std::uint8_t> slots) {
    impl_->source.setLevels(universe, slots);
}

void SacnSender::setSlotPriorities(std::uint16_t universe, std::span<const std::uint8_t> priorities) {
    impl_->source.setSlotPriorities(universe, priorities);
}

std::optional<TimePoint> SacnSender::nextDue() const {
    return impl_->source.nextDue();
}

void SacnSender::sendDue(TimePoint now) {
    impl_->source.emitDue(now, impl_->emit());
}

void SacnSender::terminate() {
    impl_->source.terminate(impl_->emit());
}

std::uint64_t SacnSender::packetCount() const {
    return impl_->packetCount;
}

}  // namespace hazer::protocol
