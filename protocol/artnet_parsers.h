// The parsers of single packets. Only for artnet*.cpp: others call parseArtNet.
#pragma once

#include "protocol/artnet.h"
#include "protocol/byte_reader.h"

namespace hazer::protocol::artnet {

// `body` is what follows OpCode and protocol version; in an ArtPollReply, which has no version, what follows
// the OpCode.

ArtNetPacket parsePoll(std::span<const std::uint8_t> body);
ArtNetPacket parsePollReply(std::span<const std::uint8_t> body);
ArtNetPacket parseDiagData(ByteReader body);
ArtNetPacket parseAddress(ByteReader body);
ArtNetPacket parseIpProg(ByteReader body);
ArtNetPacket parseTimeCode(ByteReader body);
ArtNetPacket parseTrigger(ByteReader body);

/// A text field of fixed size, up to its first NUL.
std::string_view readText(ByteReader& reader, std::size_t fieldSize);

}  // namespace hazer::protocol::artnet
