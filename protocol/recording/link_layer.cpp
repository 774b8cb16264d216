#include "protocol/recording/link_layer.h"

#include <pcap/dlt.h>

#include "protocol/byte_reader.h"

namespace hazer::protocol {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::uint16_t kEtherTypeIpv4 = 0x0800;
constexpr std::uint16_t kEtherTypeIpv6 = 0x86DD;
constexpr int kMaxVlanTags = 4;

// DLT_RAW differs from system to system, but files have these.
constexpr int kRawOfFiles = 101;
constexpr int kRawOfBsd = 14;

bool isVlanTag(std::uint16_t etherType) {
    return etherType == 0x8100 || etherType == 0x88A8 || etherType == 0x9100;
}

Bytes restOf(ByteReader& reader) {
    return reader.take(reader.remaining());
}

/// `reader` stands behind an EtherType.
std::optional<Bytes> behindEtherType(std::uint16_t etherType, ByteReader& reader) {
    for (int tags = 0; isVlanTag(etherType); ++tags) {
        if (tags == kMaxVlanTags) return std::nullopt;
        reader.u16BigEndian();  // priority and VLAN number
        etherType = reader.u16BigEndian();
    }
    if (reader.failed()) return std::nullopt;
    if (etherType != kEtherTypeIpv4 && etherType != kEtherTypeIpv6) return std::nullopt;
    return restOf(reader);
}

std::optional<Bytes> behindEthernet(ByteReader reader) {
    reader.take(12);  // MAC addresses
    const std::uint16_t etherType = reader.u16BigEndian();
    return behindEtherType(etherType, reader);
}

std::optional<Bytes> behindCooked(ByteReader reader) {
    reader.take(14);  // packet type, kind of card, its address
    const std::uint16_t etherType = reader.u16BigEndian();
    return behindEtherType(etherType, reader);
}

std::optional<Bytes> behindCookedV2(ByteReader reader) {
    const std::uint16_t etherType = reader.u16BigEndian();
    reader.take(18);
    return behindEtherType(etherType, reader);
}

/// Four bytes name the address family, in the byte order and with the numbers of whoever captured. The IP
/// packet says itself which version it is.
std::optional<Bytes> behindLoopback(ByteReader reader) {
    reader.take(4);
    if (reader.failed()) return std::nullopt;
    return restOf(reader);
}

}  // namespace

bool isKnownLinkType(int linkType) {
    switch (linkType) {
        case DLT_EN10MB:
        case DLT_LINUX_SLL:
        case DLT_LINUX_SLL2:
        case DLT_NULL:
        case DLT_LOOP:
        case DLT_RAW:
        case kRawOfFiles:
        case kRawOfBsd:
        case DLT_IPV4:
        case DLT_IPV6:
            return true;
        default:
            return false;
    }
}

std::optional<std::span<const std::uint8_t>> ipPacketOf(int linkType, std::span<const std::uint8_t> frame) {
    switch (linkType) {
        case DLT_EN10MB:
            return behindEthernet(ByteReader(frame));
        case DLT_LINUX_SLL:
            return behindCooked(ByteReader(frame));
        case DLT_LINUX_SLL2:
            return behindCookedV2(ByteReader(frame));
        case DLT_NULL:
        case DLT_LOOP:
            return behindLoopback(ByteReader(frame));
        case DLT_RAW:
        case kRawOfFiles:
        case kRawOfBsd:
        case DLT_IPV4:
        case DLT_IPV6:
            return frame;
        default:
            return std::nullopt;
    }
}

}  // namespace hazer::protocol
