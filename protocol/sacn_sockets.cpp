#include "protocol/sacn_sockets.h"

#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <asio/ip/v6_only.hpp>
#include <cstring>

#include "protocol/datagram_batch.h"
#include "protocol/network_error.h"
#include "protocol/sacn_group.h"
#include "protocol/udp.h"

namespace hazer::protocol {
namespace {

using asio::ip::udp;

// Asked for so that a stall of the thread loses no packets. Systems grant less by default (Linux:
// net.core.rmem_max).
constexpr int kReceiveBufferBytes = 1 << 20;

template <typename Value>
std::error_code setOption(udp::socket& socket, int level, int name, const Value& value) {
    if (setsockopt(socket.native_handle(), level, name, &value, sizeof value) == 0) return {};
    return {errno, std::system_category()};
}

// Linux gives a socket the groups that any other socket of the machine has joined unless told otherwise.
void hearOwnGroupsOnly([[maybe_unused]] udp::socket& socket, [[maybe_unused]] bool isIpv6) {
#ifdef IP_MULTICAST_ALL
    if (!isIpv6) setOption(socket, IPPROTO_IP, IP_MULTICAST_ALL, 0);
#endif
#ifdef IPV6_MULTICAST_ALL
    if (isIpv6) setOption(socket, IPPROTO_IPV6, IPV6_MULTICAST_ALL, 0);
#endif
}

std::error_code changeMembership(udp::socket& socket, const SacnMembership& membership, bool isJoin) {
    if (membership.isIpv6) {
        ipv6_mreq request{};
        const auto group = sacnGroupV6(membership.number, 0).address;
        std::memcpy(&request.ipv6mr_multiaddr, group.data(), group.size());
        request.ipv6mr_interface = membership.interfaceIndex;
        return setOption(socket, IPPROTO_IPV6, isJoin ? IPV6_JOIN_GROUP : IPV6_LEAVE_GROUP, request);
    }
    ip_mreqn request{};
    const auto group = sacnGroupV4(membership.number, 0).address;
    std::memcpy(&request.imr_multiaddr, group.data(), sizeof request.imr_multiaddr);
    request.imr_ifindex = static_cast<int>(membership.interfaceIndex);
    return setOption(socket, IPPROTO_IP, isJoin ? IP_ADD_MEMBERSHIP : IP_DROP_MEMBERSHIP, request);
}

bool isOutOfPlaces(const std::error_code& failure) {
    return failure == std::errc::no_buffer_space || failure == std::errc::not_enough_memory;
}

}  // namespace

SacnSockets::SacnSockets(asio::io_context& context, std::optional<asio::ip::address_v4> local4,
                         std::optional<asio::ip::address_v6> local6, std::uint16_t port,
                         OnReadable onReadable, OnNotice onNotice)
    : context_(context), onReadable_(std::move(onReadable)), onNotice_(std::move(onNotice)), port_(port) {
    if (local4) open(*local4);
    if (!local6) return;
    try {
        open(*local6);
        hasIpv6_ = true;
    } catch (const NetworkError& error) {
        if (!local4) throw;
        noticeOnce(fmt::format("sACN is received over IPv4 alone: {}", error.what()));
    }
}

void SacnSockets::setMemberships(const std::set<SacnMembership>& wanted) {
    std::set<SacnMembership> missing = wanted;
    for (const auto& one : sockets_) {
        one->isFull = false;
        const std::set<SacnMembership> before = one->joined;
        for (const SacnMembership& membership : before) {
            if (!wanted.contains(membership)) leave(*one, membership);
            missing.erase(membership);
        }
    }
    for (const SacnMembership& membership : missing) join(membership);
}

std::size_t SacnSockets::membershipCount() const {
    std::size_t count = 0;
    for (const auto& one : sockets_) count += one->joined.size();
    return count;
}

// SO_REUSEADDR lets hazer live beside another sACN program on this machine, and its own sockets beside each
// other. Never SO_REUSEPORT: Linux then deals unicast packets out among them.
SacnSockets::GroupSocket& SacnSockets::open(const asio::ip::address& local) {
    auto one = std::make_unique<GroupSocket>(context_, local.is_v6());
    udp::socket& socket = one->socket;
    const udp::endpoint endpoint(local, port_);
    std::error_code failure;
    socket.open(endpoint.protocol(), failure);
    if (!failure) socket.set_option(udp::socket::reuse_address(true), failure);
    if (!failure && local.is_v6()) socket.set_option(asio::ip::v6_only(true), failure);
    if (!failure) hearOwnGroupsOnly(socket, local.is_v6());
    if (!failure) DatagramBatch::prepare(socket.native_handle(), local.is_v6());
    if (!failure) socket.bind(endpoint, failure);
    if (!failure) socket.non_blocking(true, failure);
    if (failure) throwNetworkError("listen on", endpoint, failure);
    std::error_code smallerBufferWillDo;
    socket.set_option(udp::socket::receive_buffer_size(kReceiveBufferBytes), smallerBufferWillDo);
    port_ = socket.local_endpoint().port();
    sockets_.push_back(std::move(one));
    waitFor(*sockets_.back());
    return *sockets_.back();
}

void SacnSockets::waitFor(GroupSocket& one) {
    one.socket.async_wait(udp::socket::wait_read, [this, &one](const std::error_code& failure) {
        if (failure) return;  // the socket is being closed
        onReadable_(one.socket);
        waitFor(one);
    });
}

// Fails only where the interface has gone, and the membership with it.
void SacnSockets::leave(GroupSocket& one, const SacnMembership& membership) {
    changeMembership(one.socket, membership, false);
    one.joined.erase(membership);
}

void SacnSockets::join(const SacnMembership& membership) {
    if (membership.isIpv6 && !hasIpv6_) return;
    GroupSocket* one = withRoom(membership.isIpv6);
    while (one && !tryJoin(*one, membership) && one->isFull) one = withRoom(membership.isIpv6);
}

bool SacnSockets::tryJoin(GroupSocket& one, const SacnMembership& membership) {
    const std::error_code failure = changeMembership(one.socket, membership, true);
    if (!failure || failure == std::errc::address_in_use) {
        one.joined.insert(membership);
        return true;
    }
    one.isFull = isOutOfPlaces(failure);
    // An interface that went away this moment is no news: it is looked at again soon.
    if (failure != std::errc::no_such_device && (!one.isFull || one.joined.empty())) {
        noticeOnce(
            fmt::format("some sACN multicast groups cannot be joined: {}; send to this machine by unicast",
                        failure.message()));
    }
    return false;
}

// A socket that can join one more group, a new one if need be; null where the system gives no more sockets,
// or sockets that cannot join a single group.
SacnSockets::GroupSocket* SacnSockets::withRoom(bool isIpv6) {
    for (const auto& one : sockets_) {
        if (one->isIpv6 != isIpv6) continue;
        if (one->isFull && one->joined.empty()) return nullptr;
        if (!one->isFull && one->joined.size() < kGroupsPerSocket) return one.get();
    }
    try {
        return &open(isIpv6 ? asio::ip::address(asio::ip::address_v6::any())
                            : asio::ip::address(asio::ip::address_v4::any()));
    } catch (const NetworkError& error) {
        noticeOnce(fmt::format("some sACN multicast groups are not heard: {}", error.what()));
        return nullptr;
    }
}

void SacnSockets::noticeOnce(const std::string& sentence) {
    if (noticed_.insert(sentence).second && onNotice_) onNotice_(sentence);
}

}  // namespace hazer::protocol
