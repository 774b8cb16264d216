// IP packets in, UDP datagrams out: headers read, fragments put together.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "protocol/endpoint.h"

namespace hazer::protocol {

struct UdpDatagram {
    IpEndpoint from{};
    IpEndpoint to{};
    std::span<const std::uint8_t> bytes{};
    bool isCut = false;  ///< The capture holds less of it than was on the wire.
};

/// The UDP ports of Art-Net and sACN.
bool isLightingPort(std::uint16_t port);

/// What belongs together in fragments (RFC 791 section 3.2, RFC 8200 section 4.5).
struct FragmentKey {
    IpEndpoint from{};  ///< Its port is 0.
    IpEndpoint to{};
    std::uint32_t id = 0;
    bool operator==(const FragmentKey&) const = default;
};

/// Reads IPv4 and IPv6. Checksums are not looked at: captures taken on the sending machine have unfinished
/// ones. A value: copying it copies the fragments that still wait. Not thread-safe.
class UdpExtractor {
 public:
    /// Datagrams that can wait for fragments at once; the oldest makes room.
    static constexpr std::size_t kMaxWaiting = 64;

    /// A datagram that waits longer is given up (RFC 1122 section 3.3.2 wants a fixed time of this order).
    static constexpr std::chrono::seconds kMaxWait{30};

    /// Takes an IP packet. Gives a datagram if it is one, or completes one; valid until the next call.
    std::optional<UdpDatagram> take(std::span<const std::uint8_t> ipPacket, std::chrono::nanoseconds now);

    /// Datagrams to a lighting port given up because fragments were missing, overlapped or were too long
    /// together.
    std::uint64_t lostCount() const { return lostCount_; }

    /// Datagrams that wait for fragments now.
    std::size_t waitingCount() const { return waiting_.size(); }

 private:
    struct Packet {
        FragmentKey key{};
        bool isFragment = false;
        bool isLast = true;       ///< No fragment follows it.
        std::size_t offset = 0;   ///< Of `bytes` in the whole datagram.
        std::size_t missing = 0;  ///< Bytes that the capture cut off the end.
        std::span<const std::uint8_t> bytes{};
    };

    struct Waiting {
        FragmentKey key{};
        std::chrono::nanoseconds since{};
        std::vector<std::uint8_t> bytes{};
        std::vector<bool> present{};  ///< For each eight bytes.
        std::optional<std::size_t> size{};
    };

    static std::optional<Packet> parseIpv4(std::span<const std::uint8_t> packet);
    static std::optional<Packet> parseIpv6(std::span<const std::uint8_t> packet);
    static std::optional<UdpDatagram> datagramOf(const Packet& packet);

    std::optional<UdpDatagram> join(const Packet& fragment, std::chrono::nanoseconds now);
    Waiting& waitingFor(const FragmentKey& key, std::chrono::nanoseconds now);
    void giveUpOld(std::chrono::nanoseconds now);
    void giveUp(const FragmentKey& key);

    std::vector<Waiting> waiting_;
    std::vector<std::uint8_t> joined_;
    std::uint64_t lostCount_ = 0;
};

}  // namespace hazer::protocol
