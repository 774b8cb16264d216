// What the packets of Art-Net have in common on the wire. Only for the .cpp files that parse and pack them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "protocol/byte_reader.h"
#include "protocol/field_writer.h"

namespace hazer::protocol::artnet {

inline constexpr std::array<std::uint8_t, 8> kIdentifier{'A', 'r', 't', '-', 'N', 'e', 't', 0};
inline constexpr std::uint16_t kProtocolVersion = 14;

/// Identifier, OpCode and protocol version.
inline constexpr std::size_t kHeaderSize = 12;

// OpCodes (table "OpCodes"), sent low byte first.
inline constexpr std::uint16_t kOpPoll = 0x2000;
inline constexpr std::uint16_t kOpPollReply = 0x2100;
inline constexpr std::uint16_t kOpDiagData = 0x2300;
inline constexpr std::uint16_t kOpDmx = 0x5000;
inline constexpr std::uint16_t kOpNzs = 0x5100;
inline constexpr std::uint16_t kOpSync = 0x5200;
inline constexpr std::uint16_t kOpAddress = 0x6000;
inline constexpr std::uint16_t kOpTimeCode = 0x9700;
inline constexpr std::uint16_t kOpTrigger = 0x9900;
inline constexpr std::uint16_t kOpIpProg = 0xF800;
inline constexpr std::uint16_t kOpIpProgReply = 0xF900;

/// The high byte of a Port-Address on the wire has 7 bits; the eighth belongs to nobody and is not trusted to
/// be 0.
inline constexpr std::uint8_t kNetMask = 0x7F;

/// Reads SubUni, then Net.
inline std::uint16_t readPortAddress(ByteReader& reader) {
    const std::uint8_t subUni = reader.u8();
    const auto net = static_cast<std::uint8_t>(reader.u8() & kNetMask);
    return static_cast<std::uint16_t>(net << 8 | subUni);
}

/// The bytes that every packet but ArtPollReply begins with.
inline void writeHeader(FieldWriter& writer, std::uint16_t opCode) {
    writer.bytes(kIdentifier);
    writer.u16LittleEndian(opCode);
    writer.u16BigEndian(kProtocolVersion);
}

}  // namespace hazer::protocol::artnet
