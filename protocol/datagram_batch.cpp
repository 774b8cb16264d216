#include "protocol/datagram_batch.h"

#include <netinet/in.h>
#include <sys/socket.h>
#include <time.h>

#include <array>
#include <cstring>

namespace hazer::protocol {
namespace {

// Room for an address with its interface and a time.
constexpr std::size_t kControlSize = 256;

template <typename Value>
Value controlValue(const cmsghdr& header) {
    Value value{};
    std::memcpy(&value, CMSG_DATA(&header), sizeof value);
    return value;
}

IpEndpoint endpointOf(const sockaddr_storage& address) {
    IpEndpoint endpoint;
    if (address.ss_family == AF_INET6) {
        sockaddr_in6 v6{};
        std::memcpy(&v6, &address, sizeof v6);
        std::memcpy(endpoint.address.data(), &v6.sin6_addr, sizeof v6.sin6_addr);
        endpoint.isIpv6 = true;
        endpoint.port = ntohs(v6.sin6_port);
    } else {
        sockaddr_in v4{};
        std::memcpy(&v4, &address, sizeof v4);
        std::memcpy(endpoint.address.data(), &v4.sin_addr, sizeof v4.sin_addr);
        endpoint.port = ntohs(v4.sin_port);
    }
    return endpoint;
}

void takeControl(const cmsghdr& header, ArrivedDatagram& arrived) {
    IpEndpoint& to = arrived.datagram.to;
    if (header.cmsg_level == IPPROTO_IP && header.cmsg_type == IP_PKTINFO) {
        const auto info = controlValue<in_pktinfo>(header);
        std::memcpy(to.address.data(), &info.ipi_addr, sizeof info.ipi_addr);
        arrived.interfaceIndex = static_cast<unsigned>(info.ipi_ifindex);
    } else if (header.cmsg_level == IPPROTO_IPV6 && header.cmsg_type == IPV6_PKTINFO) {
        const auto info = controlValue<in6_pktinfo>(header);
        std::memcpy(to.address.data(), &info.ipi6_addr, sizeof info.ipi6_addr);
        arrived.interfaceIndex = info.ipi6_ifindex;
#ifdef SO_RXQ_OVFL
    } else if (header.cmsg_level == SOL_SOCKET && header.cmsg_type == SO_RXQ_OVFL) {
        arrived.lostBefore = controlValue<std::uint32_t>(header);
#endif
#ifdef SCM_TIMESTAMPNS
    } else if (header.cmsg_level == SOL_SOCKET && header.cmsg_type == SCM_TIMESTAMPNS) {
        const auto time = controlValue<timespec>(header);
        arrived.datagram.time =
            WallTime(std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec));
#endif
    }
}

}  // namespace

struct DatagramBatch::Buffers {
    struct One {
        std::array<std::uint8_t, kMaxDatagramSize> bytes;
        alignas(cmsghdr) std::array<std::uint8_t, kControlSize> control;
        sockaddr_storage from;
        iovec vector;
    };

    msghdr& headerOf(std::size_t index) {
#ifdef __linux__
        return headers[index].msg_hdr;
#else
        return headers[index];
#endif
    }

    std::size_t sizeOf(std::size_t index) const {
#ifdef __linux__
        return headers[index].msg_len;
#else
        return sizes[index];
#endif
    }

    // The system writes sizes into the headers, so that each receive needs them anew.
    void reset() {
        for (std::size_t i = 0; i < kCapacity; ++i) {
            One& one = all[i];
            one.vector = {one.bytes.data(), one.bytes.size()};
            msghdr& header = headerOf(i);
            header = {};
            header.msg_name = &one.from;
            header.msg_namelen = sizeof one.from;
            header.msg_iov = &one.vector;
            header.msg_iovlen = 1;
            header.msg_control = one.control.data();
            header.msg_controllen = one.control.size();
        }
    }

    std::size_t receive(int socket) {
#ifdef __linux__
        const int count = recvmmsg(socket, headers.data(), kCapacity, MSG_DONTWAIT, nullptr);
        return count < 0 ? 0 : static_cast<std::size_t>(count);
#else
        std::size_t count = 0;
        while (count < kCapacity) {
            const auto size = recvmsg(socket, &headers[count], MSG_DONTWAIT);
            if (size < 0) break;
            sizes[count++] = static_cast<std::size_t>(size);
        }
        return count;
#endif
    }

    ArrivedDatagram arrived(std::size_t index, std::uint16_t port, WallTime now) {
        msghdr& header = headerOf(index);
        ArrivedDatagram result;
        result.datagram.from = endpointOf(all[index].from);
        result.datagram.to = {.isIpv6 = result.datagram.from.isIpv6, .port = port};
        result.datagram.time = now;
        result.datagram.bytes = std::span(all[index].bytes).first(sizeOf(index));
        for (cmsghdr* one = CMSG_FIRSTHDR(&header); one; one = CMSG_NXTHDR(&header, one)) {
            takeControl(*one, result);
        }
        return result;
    }

    std::array<One, kCapacity> all;
    std::array<ArrivedDatagram, kCapacity> results;
#ifdef __linux__
    std::array<mmsghdr, kCapacity> headers{};
#else
    std::array<msghdr, kCapacity> headers{};
    std::array<std::size_t, kCapacity> sizes{};
#endif
};

DatagramBatch::DatagramBatch() : buffers_(std::make_unique<Buffers>()) {}

DatagramBatch::~DatagramBatch() = default;

void DatagramBatch::prepare(int socket, bool isIpv6) {
    const int on = 1;
    if (isIpv6) {
        setsockopt(socket, IPPROTO_IPV6, IPV6_RECVPKTINFO, &on, sizeof on);
    } else {
        setsockopt(socket, IPPROTO_IP, IP_PKTINFO, &on, sizeof on);
    }
#ifdef SO_RXQ_OVFL
    setsockopt(socket, SOL_SOCKET, SO_RXQ_OVFL, &on, sizeof on);
#endif
#ifdef SO_TIMESTAMPNS
    setsockopt(socket, SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof on);
#endif
}

std::span<const ArrivedDatagram> DatagramBatch::receive(int socket, std::uint16_t port) {
    buffers_->reset();
    const std::size_t count = buffers_->receive(socket);
    const auto now = std::chrono::time_point_cast<std::chrono::nanoseconds>(std::chrono::system_clock::now());
    for (std::size_t i = 0; i < count; ++i) buffers_->results[i] = buffers_->arrived(i, port, now);
    return std::span(buffers_->results).first(count);
}

}  // namespace hazer::protocol
