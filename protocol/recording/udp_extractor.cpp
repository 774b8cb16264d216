#include "protocol/recording/udp_extractor.h"

#include <algorithm>

#include "protocol/artnet.h"
#include "protocol/byte_reader.h"
#include "protocol/recording/udp_header.h"
#include "protocol/sacn.h"

namespace hazer::protocol {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t kMaxDatagramSize = 65535;
constexpr std::size_t kFragmentUnit = 8;  // offsets count in eight bytes

constexpr std::uint8_t kHopByHop = 0;
constexpr std::uint8_t kRouting = 43;
constexpr std::uint8_t kFragmentHeader = 44;
constexpr std::uint8_t kDestinationOptions = 60;
constexpr int kMaxExtensionHeaders = 8;

IpEndpoint endpointOf(Bytes address, bool isIpv6) {
    IpEndpoint endpoint;
    std::ranges::copy(address, endpoint.address.begin());
    endpoint.isIpv6 = isIpv6;
    return endpoint;
}

std::uint32_t u32BigEndian(ByteReader& reader) {
    const std::uint32_t high = reader.u16BigEndian();
    return high << 16 | reader.u16BigEndian();
}

}  // namespace

bool isLightingPort(std::uint16_t port) {
    return port == kArtNetPort || port == kSacnPort;
}

std::optional<UdpDatagram> UdpExtractor::take(Bytes ipPacket, std::chrono::nanoseconds now) {
    giveUpOld(now);
    if (ipPacket.empty()) return std::nullopt;
    const int version = ipPacket[0] >> 4;
    std::optional<Packet> packet;
    if (version == 4) packet = parseIpv4(ipPacket);
    if (version == 6) packet = parseIpv6(ipPacket);
    if (!packet) return std::nullopt;
    return packet->isFragment ? join(*packet, now) : datagramOf(*packet);
}

std::optional<UdpExtractor::Packet> UdpExtractor::parseIpv4(Bytes bytes) {
    ByteReader reader(bytes);
    const std::size_t headerSize = 4u * (reader.u8() & 0x0Fu);
    reader.u8();  // type of service
    const std::size_t totalSize = reader.u16BigEndian();
    Packet packet;
    packet.key.id = reader.u16BigEndian();
    const std::uint16_t fragment = reader.u16BigEndian();
    reader.u8();  // time to live
    const std::uint8_t protocol = reader.u8();
    reader.u16BigEndian();  // checksum
    packet.key.from = endpointOf(reader.take(4), false);
    packet.key.to = endpointOf(reader.take(4), false);
    constexpr std::size_t kSmallestHeader = 20;
    if (reader.failed() || protocol != kUdp || headerSize < kSmallestHeader || bytes.size() < headerSize) {
        return std::nullopt;
    }
    // A total of 0 is what cards that cut packets themselves leave to captures on the sending machine.
    const std::size_t size = totalSize == 0 ? bytes.size() : totalSize;
    if (size < headerSize) return std::nullopt;
    packet.isLast = (fragment & 0x2000) == 0;
    packet.offset = (fragment & 0x1FFFu) * kFragmentUnit;
    packet.isFragment = !packet.isLast || packet.offset > 0;
    packet.missing = size - std::min(size, bytes.size());
    packet.bytes = bytes.first(std::min(size, bytes.size())).subspan(headerSize);
    return packet;
}

std::optional<UdpExtractor::Packet> UdpExtractor::parseIpv6(Bytes bytes) {
    ByteReader reader(bytes);
    reader.take(4);  // version, traffic class, flow label
    const std::size_t payloadSize = reader.u16BigEndian();
    std::uint8_t next = reader.u8();
    reader.u8();  // hop limit
    Packet packet;
    packet.key.from = endpointOf(reader.take(16), true);
    packet.key.to = endpointOf(reader.take(16), true);
    if (reader.failed()) return std::nullopt;
    packet.missing = payloadSize - std::min(payloadSize, reader.remaining());
    ByteReader payload(reader.take(std::min(payloadSize, reader.remaining())));
    for (int headers = 0; next != kUdp; ++headers) {
        if (headers == kMaxExtensionHeaders || packet.offset > 0) return std::nullopt;
        const std::uint8_t kind = next;
        next = payload.u8();
        const std::size_t extra = payload.u8();
        if (kind == kFragmentHeader) {
            const std::uint16_t fragment = payload.u16BigEndian();
            packet.key.id = u32BigEndian(payload);
            packet.isLast = (fragment & 1) == 0;
            packet.offset = fragment & 0xFFF8u;
            packet.isFragment = !packet.isLast || packet.offset > 0;
        } else if (kind == kHopByHop || kind == kRouting || kind == kDestinationOptions) {
            payload.take(kFragmentUnit * extra + kFragmentUnit - 2);
        } else {
            return std::nullopt;
        }
        if (payload.failed()) return std::nullopt;
    }
    packet.bytes = payload.take(payload.remaining());
    return packet;
}

std::optional<UdpDatagram> UdpExtractor::datagramOf(const Packet& packet) {
    ByteReader reader(packet.bytes);
    UdpDatagram datagram{packet.key.from, packet.key.to, {}, false};
    datagram.from.port = reader.u16BigEndian();
    datagram.to.port = reader.u16BigEndian();
    const std::size_t size = reader.u16BigEndian();
    reader.u16BigEndian();  // checksum
    if (reader.failed() || size < kUdpHeaderSize) return std::nullopt;
    const std::size_t payloadSize = size - kUdpHeaderSize;
    datagram.isCut = payloadSize > reader.remaining();
    datagram.bytes = reader.take(std::min(payloadSize, reader.remaining()));
    return datagram;
}

std::optional<UdpDatagram> UdpExtractor::join(const Packet& fragment, std::chrono::nanoseconds now) {
    const std::size_t end = fragment.offset + fragment.bytes.size();
    const bool isOdd = !fragment.isLast && fragment.bytes.size() % kFragmentUnit != 0;
    Waiting& whole = waitingFor(fragment.key, now);
    const bool contradictsEnd = whole.size && (end > *whole.size || (fragment.isLast && end != *whole.size));
    const bool endsTooEarly = fragment.isLast && end < whole.bytes.size();
    if (fragment.bytes.empty() || fragment.missing > 0 || isOdd || end > kMaxDatagramSize || contradictsEnd ||
        endsTooEarly) {
        giveUp(fragment.key);
        return std::nullopt;
    }
    if (whole.bytes.size() < end) whole.bytes.resize(end);
    whole.present.resize((whole.bytes.size() + kFragmentUnit - 1) / kFragmentUnit, false);
    const auto first = whole.present.begin() + static_cast<std::ptrdiff_t>(fragment.offset / kFragmentUnit);
    const auto last = whole.present.begin() + static_cast<std::ptrdiff_t>((end - 1) / kFragmentUnit + 1);
    if (std::find(first, last, true) != last) {
        // A capture may hold a fragment twice. Overlaps that differ are how firewalls are deceived; nobody
        // sends them in good faith (RFC 5722).
        const bool isRepeated =
            std::find(first, last, false) == last &&
            std::ranges::equal(Bytes(whole.bytes).subspan(fragment.offset, fragment.bytes.size()),
                               fragment.bytes);
        if (!isRepeated) giveUp(fragment.key);
        return std::nullopt;
    }
    std::fill(first, last, true);
    std::ranges::copy(fragment.bytes, whole.bytes.begin() + static_cast<std::ptrdiff_t>(fragment.offset));
    if (fragment.isLast) whole.size = end;
    if (!whole.size || std::ranges::find(whole.present, false) != whole.present.end()) return std::nullopt;
    joined_.swap(whole.bytes);
    std::erase_if(waiting_, [&](const Waiting& other) { return other.key == fragment.key; });
    return datagramOf({.key = fragment.key, .bytes = joined_});
}

UdpExtractor::Waiting& UdpExtractor::waitingFor(const FragmentKey& key, std::chrono::nanoseconds now) {
    const auto known = std::ranges::find(waiting_, key, &Waiting::key);
    if (known != waiting_.end()) return *known;
    if (waiting_.size() == kMaxWaiting) giveUp(waiting_.front().key);
    waiting_.push_back({.key = key, .since = now});
    return waiting_.back();
}

void UdpExtractor::giveUpOld(std::chrono::nanoseconds now) {
    while (!waiting_.empty() && now - waiting_.front().since > kMaxWait) giveUp(waiting_.front().key);
}

void UdpExtractor::giveUp(const FragmentKey& key) {
    const auto lost = std::ranges::find(waiting_, key, &Waiting::key);
    if (!lost->present.empty() && lost->present[0]) {
        ByteReader header(lost->bytes);
        header.u16BigEndian();  // port of the sender
        if (isLightingPort(header.u16BigEndian())) ++lostCount_;
    }
    waiting_.erase(lost);
}

}  // namespace hazer::protocol
