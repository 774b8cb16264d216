// The bytes of a pcap file with nanoseconds, as hazer writes it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "protocol/datagram.h"

namespace hazer::protocol {

/// The largest payload that fits into a record: what IPv4 leaves of 65535 bytes.
inline constexpr std::size_t kMaxRecordedPayload = 65535 - 20 - 8;

inline constexpr std::size_t kPcapFileHeaderSize = 24;

/// What a record adds to its payload, at most.
inline constexpr std::size_t kPcapRecordOverhead = 16 + 40 + 8;

/// The head of a file of raw IP packets (LINKTYPE_RAW), little-endian.
std::vector<std::uint8_t> packPcapFileHeader();

/// Appends a record: the payload behind made IP and UDP headers with its true addresses and right checksums.
/// Payload at most kMaxRecordedPayload.
void appendPcapRecord(std::vector<std::uint8_t>& out, const Datagram& datagram);

/// Records that stand whole within the first `size` bytes of `records`, which hold one behind another.
struct WholeRecords {
    std::size_t bytes = 0;
    std::uint64_t count = 0;
};
WholeRecords wholeRecords(std::span<const std::uint8_t> records, std::size_t size);

}  // namespace hazer::protocol
