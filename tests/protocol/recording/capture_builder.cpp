#include "tests/protocol/recording/capture_builder.h"

#include <algorithm>
#include <cstdlib>

namespace hazer::protocol::test {
namespace {

constexpr std::uint8_t kUdp = 17;

std::uint8_t byteOf(std::uint64_t value, int index) {
    return static_cast<std::uint8_t>(value >> (8 * index) & 0xFF);
}

Bytes ipv4Header(std::size_t payloadSize, std::uint8_t lastByteOfSource, std::uint16_t id,
                 std::size_t fragment) {
    return joined({{0x45, 0},
                   bigEndian16(20 + payloadSize),
                   bigEndian16(id),
                   bigEndian16(fragment),
                   {64, kUdp, 0, 0},
                   {10, 0, 0, lastByteOfSource},
                   {10, 0, 0, 99}});
}

Bytes ipv6Address(std::uint8_t lastByte) {
    Bytes address(16);
    address[0] = 0xFD;
    address[15] = lastByte;
    return address;
}

Bytes ipv6Header(std::size_t payloadSize, std::uint8_t next, std::uint8_t lastByteOfSource) {
    return joined({{0x60, 0, 0, 0},
                   bigEndian16(payloadSize),
                   {next, 64},
                   ipv6Address(lastByteOfSource),
                   ipv6Address(99)});
}

Bytes part(const Bytes& bytes, std::size_t offset, std::size_t size) {
    const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(offset);
    return Bytes(first, first + static_cast<std::ptrdiff_t>(std::min(size, bytes.size() - offset)));
}

Bytes pcapngBlock(std::uint32_t type, const Bytes& body) {
    const Bytes padded = joined({body, Bytes((4 - body.size() % 4) % 4)});
    const Bytes size = littleEndian32(padded.size() + 12);
    return joined({littleEndian32(type), size, padded, size});
}

}  // namespace

Bytes joined(const std::vector<Bytes>& parts) {
    Bytes whole;
    for (const Bytes& bytes : parts) whole.insert(whole.end(), bytes.begin(), bytes.end());
    return whole;
}

Bytes bigEndian16(std::size_t value) {
    return {byteOf(value, 1), byteOf(value, 0)};
}

Bytes littleEndian16(std::size_t value) {
    return {byteOf(value, 0), byteOf(value, 1)};
}

Bytes littleEndian32(std::uint64_t value) {
    return {byteOf(value, 0), byteOf(value, 1), byteOf(value, 2), byteOf(value, 3)};
}

Bytes bigEndian32(std::uint64_t value) {
    return {byteOf(value, 3), byteOf(value, 2), byteOf(value, 1), byteOf(value, 0)};
}

Bytes udpPacket(const UdpFields& fields) {
    return joined({bigEndian16(fields.sourcePort),
                   bigEndian16(fields.port),
                   bigEndian16(8 + fields.payload.size()),
                   {0xBA, 0xAD},
                   fields.payload});
}

Bytes ipv4Packet(const UdpFields& fields) {
    const Bytes udp = udpPacket(fields);
    return joined({ipv4Header(udp.size(), fields.lastByteOfSource, 0, 0), udp});
}

Bytes ipv6Packet(const UdpFields& fields) {
    const Bytes udp = udpPacket(fields);
    return joined({ipv6Header(udp.size(), kUdp, fields.lastByteOfSource), udp});
}

std::vector<Bytes> ipv4Fragments(const UdpFields& fields, std::size_t size, std::uint16_t id) {
    const Bytes udp = udpPacket(fields);
    std::vector<Bytes> fragments;
    for (std::size_t offset = 0; offset < udp.size(); offset += size) {
        const Bytes bytes = part(udp, offset, size);
        const std::size_t moreFollow = offset + size < udp.size() ? 0x2000 : 0;
        fragments.push_back(
            joined({ipv4Header(bytes.size(), fields.lastByteOfSource, id, moreFollow | offset / 8), bytes}));
    }
    return fragments;
}

std::vector<Bytes> ipv6Fragments(const UdpFields& fields, std::size_t size, std::uint32_t id) {
    constexpr std::uint8_t kFragmentHeader = 44;
    const Bytes udp = udpPacket(fields);
    std::vector<Bytes> fragments;
    for (std::size_t offset = 0; offset < udp.size(); offset += size) {
        const Bytes bytes = part(udp, offset, size);
        const std::size_t moreFollow = offset + size < udp.size() ? 1 : 0;
        fragments.push_back(joined({ipv6Header(8 + bytes.size(), kFragmentHeader, fields.lastByteOfSource),
                                    {kUdp, 0},
                                    bigEndian16(offset | moreFollow),
                                    bigEndian32(id),
                                    bytes}));
    }
    return fragments;
}

Bytes ethernetFrame(const Bytes& ipPacket) {
    const bool isIpv6 = !ipPacket.empty() && ipPacket[0] >> 4 == 6;
    return joined({Bytes(12), bigEndian16(isIpv6 ? 0x86DD : 0x0800), ipPacket});
}

Bytes pcapFile(const std::vector<CapturedFrame>& frames, int linkType, PcapKind kind) {
    const bool isBig = kind == PcapKind::kBigEndianMicroseconds || kind == PcapKind::kBigEndianNanoseconds;
    const bool isNano = kind == PcapKind::kNanoseconds || kind == PcapKind::kBigEndianNanoseconds;
    const auto u32 = isBig ? bigEndian32 : littleEndian32;
    const auto u16 = isBig ? bigEndian16 : littleEndian16;
    Bytes file = joined({u32(isNano ? 0xA1B23C4D : 0xA1B2C3D4), u16(2), u16(4), u32(0), u32(0), u32(65535),
                         u32(static_cast<std::uint64_t>(linkType))});
    for (const CapturedFrame& frame : frames) {
        const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(frame.time);
        const auto rest = (frame.time - seconds).count() / (isNano ? 1 : 1000);
        file = joined({file, u32(static_cast<std::uint64_t>(seconds.count())),
                       u32(static_cast<std::uint64_t>(rest)), u32(frame.bytes.size()),
                       u32(frame.bytes.size()), frame.bytes});
    }
    return file;
}

Bytes pcapngFile(const std::vector<CapturedFrame>& frames, int linkType, int tsResolution) {
    Bytes file = pcapngBlock(0x0A0D0D0A, joined({littleEndian32(0x1A2B3C4D), littleEndian16(1),
                                                 littleEndian16(0), Bytes(8, 0xFF)}));
    const Bytes resolution = joined(
        {littleEndian16(9), littleEndian16(1), {static_cast<std::uint8_t>(tsResolution), 0, 0, 0}, Bytes(4)});
    file = joined({file, pcapngBlock(1, joined({littleEndian16(static_cast<std::size_t>(linkType)),
                                                littleEndian16(0), littleEndian32(65535), resolution}))});
    std::int64_t unit = 1;
    for (int power = tsResolution; power < 9; ++power) unit *= 10;
    for (const CapturedFrame& frame : frames) {
        const auto time = static_cast<std::uint64_t>(frame.time.count() / unit);
        file = joined({file, pcapngBlock(6, joined({littleEndian32(0), littleEndian32(time >> 32),
                                                    littleEndian32(time & 0xFFFFFFFF),
                                                    littleEndian32(frame.bytes.size()),
                                                    littleEndian32(frame.bytes.size()), frame.bytes}))});
    }
    return file;
}

ReadPacket copyOf(const RecordedPacket& packet) {
    ReadPacket copy;
    copy.time = packet.time;
    if (const auto* datagram = std::get_if<RecordedDatagram>(&packet.content)) {
        copy.isDatagram = true;
        copy.from = datagram->from;
        copy.to = datagram->to;
        copy.bytes.assign(datagram->bytes.begin(), datagram->bytes.end());
    } else {
        const auto& frame = std::get<RecordedFrame>(packet.content);
        copy.universe = frame.universe;
        copy.bytes.assign(frame.slots.begin(), frame.slots.end());
    }
    return copy;
}

std::vector<ReadPacket> readAll(RecordingReader& reader) {
    std::vector<ReadPacket> packets;
    while (const auto packet = reader.next()) packets.push_back(copyOf(*packet));
    return packets;
}

std::string textOf(const Bytes& bytes) {
    return {bytes.begin(), bytes.end()};
}

std::filesystem::path capturesFolder() {
    const char* const fromEnvironment = std::getenv("HAZER_SHARED_DATA");
    const std::filesystem::path shared = fromEnvironment != nullptr
                                             ? std::filesystem::path(fromEnvironment)
                                             : std::filesystem::path(HAZER_SOURCE_DIR) / "../shared/data";
    const std::filesystem::path captures = shared / "captures";
    return std::filesystem::is_directory(captures) ? captures : std::filesystem::path();
}

}  // namespace hazer::protocol::test
