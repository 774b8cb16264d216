// Captures and show files written out by hand, so that the tests do not believe the code under test.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "protocol/recording/recording.h"
#include "tests/protocol/packets.h"

namespace hazer::protocol::test {

/// Puts parts one behind another.
Bytes joined(const std::vector<Bytes>& parts);

Bytes bigEndian16(std::size_t value);
Bytes littleEndian16(std::size_t value);
Bytes littleEndian32(std::uint64_t value);
Bytes bigEndian32(std::uint64_t value);

struct UdpFields {
    std::uint8_t lastByteOfSource = 1;  // 10.0.0.x, or fd00::x
    std::uint16_t sourcePort = 6454;
    std::uint16_t port = 6454;
    Bytes payload = dmxDatagram({});
};

/// A UDP header and its payload; the checksum is nonsense, as in captures on the sending machine.
Bytes udpPacket(const UdpFields& fields);

Bytes ipv4Packet(const UdpFields& fields);
Bytes ipv6Packet(const UdpFields& fields);

/// An IPv4 packet in fragments of `size` bytes, a multiple of 8.
std::vector<Bytes> ipv4Fragments(const UdpFields& fields, std::size_t size, std::uint16_t id = 7);
std::vector<Bytes> ipv6Fragments(const UdpFields& fields, std::size_t size, std::uint32_t id = 7);

Bytes ethernetFrame(const Bytes& ipPacket);

struct CapturedFrame {
    std::chrono::nanoseconds time{};
    Bytes bytes;
};

enum class PcapKind : std::uint8_t {
    kMicroseconds,
    kNanoseconds,
    kBigEndianMicroseconds,
    kBigEndianNanoseconds
};

Bytes pcapFile(const std::vector<CapturedFrame>& frames, int linkType = 1,
               PcapKind kind = PcapKind::kNanoseconds);

/// One section, one interface. tsResolution: the power of ten, 9 for nanoseconds.
Bytes pcapngFile(const std::vector<CapturedFrame>& frames, int linkType = 1, int tsResolution = 9);

/// A packet as a reader gave it, with a copy of what it pointed to.
struct ReadPacket {
    RecordingTime time{};
    bool isDatagram = false;
    IpEndpoint from{};
    IpEndpoint to{};
    UniverseId universe{};
    Bytes bytes;
    bool operator==(const ReadPacket&) const = default;
};

ReadPacket copyOf(const RecordedPacket& packet);
std::vector<ReadPacket> readAll(RecordingReader& reader);

std::string textOf(const Bytes& bytes);

/// Captures of real programs, which are not part of the tree; empty if they are not there.
std::filesystem::path capturesFolder();

}  // namespace hazer::protocol::test
