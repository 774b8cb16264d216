#include "protocol/recording/pcap_format.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "protocol/byte_reader.h"
#include "protocol/recording/udp_header.h"

namespace hazer::protocol {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::uint32_t kMagicNanoseconds = 0xA1B23C4D;
constexpr std::uint32_t kLinkTypeRaw = 101;
constexpr std::uint32_t kSnapLength = 65535;
constexpr std::size_t kIpv4HeaderSize = 20;
constexpr std::size_t kIpv6HeaderSize = 40;
constexpr std::uint8_t kHops = 64;

void u16Little(std::vector<std::uint8_t>& out, std::uint16_t value) {
    out.push_back(static_cast<std::uint8_t>(value & 0xFF));
    out.push_back(static_cast<std::uint8_t>(value >> 8));
}

void u32Little(std::vector<std::uint8_t>& out, std::uint32_t value) {
    u16Little(out, static_cast<std::uint16_t>(value & 0xFFFF));
    u16Little(out, static_cast<std::uint16_t>(value >> 16));
}

void u16Big(std::vector<std::uint8_t>& out, std::size_t value) {
    out.push_back(static_cast<std::uint8_t>(value >> 8 & 0xFF));
    out.push_back(static_cast<std::uint8_t>(value & 0xFF));
}

void put(std::vector<std::uint8_t>& out, Bytes bytes) {
    out.insert(out.end(), bytes.begin(), bytes.end());
}

/// The ones' complement sum of RFC 1071, not yet complemented; a lone last byte counts as a high one.
std::uint32_t sumOf(Bytes bytes, std::uint32_t sum = 0) {
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
        sum += static_cast<std::uint32_t>(bytes[i] << 8 | bytes[i + 1]);
    }
    if (bytes.size() % 2 == 1) sum += static_cast<std::uint32_t>(bytes.back() << 8);
    return sum;
}

std::uint16_t checksumOf(std::uint32_t sum) {
    while (sum > 0xFFFF) sum = (sum & 0xFFFF) + (sum >> 16);
    return static_cast<std::uint16_t>(~sum & 0xFFFF);
}

void setU16Big(std::span<std::uint8_t> bytes, std::size_t offset, std::uint16_t value) {
    bytes[offset] = static_cast<std::uint8_t>(value >> 8);
    bytes[offset + 1] = static_cast<std::uint8_t>(value & 0xFF);
}

Bytes addressOf(const IpEndpoint& endpoint) {
    return Bytes(endpoint.address).first(endpoint.isIpv6 ? 16 : 4);
}

void appendIpv4Header(std::vector<std::uint8_t>& out, const Datagram& datagram, std::size_t udpSize) {
    const std::size_t start = out.size();
    put(out, std::array<std::uint8_t, 2>{0x45, 0});  // version 4, five words; type of service
    u16Big(out, kIpv4HeaderSize + udpSize);
    put(out, std::array<std::uint8_t, 4>{0, 0, 0x40, 0});  // number; do not fragment
    put(out, std::array<std::uint8_t, 4>{kHops, kUdp, 0, 0});
    put(out, addressOf(datagram.from));
    put(out, addressOf(datagram.to));
    const std::span header = std::span(out).subspan(start);
    setU16Big(header, 10, checksumOf(sumOf(header)));
}

void appendIpv6Header(std::vector<std::uint8_t>& out, const Datagram& datagram, std::size_t udpSize) {
    put(out, std::array<std::uint8_t, 4>{0x60, 0, 0, 0});  // version 6, no traffic class, no flow
    u16Big(out, udpSize);
    put(out, std::array<std::uint8_t, 2>{kUdp, kHops});
    put(out, addressOf(datagram.from));
    put(out, addressOf(datagram.to));
}

void appendUdp(std::vector<std::uint8_t>& out, const Datagram& datagram, std::size_t udpSize) {
    const std::size_t start = out.size();
    u16Big(out, datagram.from.port);
    u16Big(out, datagram.to.port);
    u16Big(out, udpSize);
    u16Big(out, 0);
    put(out, datagram.bytes);
    std::uint32_t sum = sumOf(addressOf(datagram.from), sumOf(addressOf(datagram.to)));
    sum += kUdp + static_cast<std::uint32_t>(udpSize);
    const std::span udp = std::span(out).subspan(start);
    const std::uint16_t checksum = checksumOf(sumOf(udp, sum));
    setU16Big(udp, 6, checksum == 0 ? std::uint16_t{0xFFFF} : checksum);  // 0 would mean none (RFC 768)
}

}  // namespace

std::vector<std::uint8_t> packPcapFileHeader() {
    std::vector<std::uint8_t> out;
    u32Little(out, kMagicNanoseconds);
    u16Little(out, 2);  // version 2.4
    u16Little(out, 4);
    u32Little(out, 0);  // time zone, accuracy: always 0
    u32Little(out, 0);
    u32Little(out, kSnapLength);
    u32Little(out, kLinkTypeRaw);
    return out;
}

void appendPcapRecord(std::vector<std::uint8_t>& out, const Datagram& datagram) {
    assert(datagram.bytes.size() <= kMaxRecordedPayload);
    assert(datagram.from.isIpv6 == datagram.to.isIpv6);
    const bool isIpv6 = datagram.from.isIpv6;
    const std::size_t udpSize = kUdpHeaderSize + datagram.bytes.size();
    const auto size = static_cast<std::uint32_t>((isIpv6 ? kIpv6HeaderSize : kIpv4HeaderSize) + udpSize);
    const auto sinceEpoch = std::max(datagram.time.time_since_epoch(), std::chrono::nanoseconds(0));
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(sinceEpoch);
    u32Little(out, static_cast<std::uint32_t>(seconds.count()));
    u32Little(out, static_cast<std::uint32_t>((sinceEpoch - seconds).count()));
    u32Little(out, size);
    u32Little(out, size);
    if (isIpv6) {
        appendIpv6Header(out, datagram, udpSize);
    } else {
        appendIpv4Header(out, datagram, udpSize);
    }
    appendUdp(out, datagram, udpSize);
}

WholeRecords wholeRecords(std::span<const std::uint8_t> records, std::size_t size) {
    WholeRecords whole;
    ByteReader reader(records.first(std::min(size, records.size())));
    while (true) {
        reader.take(8);  // time
        const std::uint32_t low = reader.u16LittleEndian();
        const std::uint32_t recordSize = low | static_cast<std::uint32_t>(reader.u16LittleEndian()) << 16;
        reader.take(4);  // size on the wire
        reader.take(recordSize);
        if (reader.failed()) return whole;
        whole.bytes = std::min(size, records.size()) - reader.remaining();
        ++whole.count;
    }
}

}  // namespace hazer::protocol
