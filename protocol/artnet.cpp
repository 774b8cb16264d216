#include "protocol/artnet.h"

#include <algorithm>
#include <cassert>

#include "protocol/artnet_parsers.h"
#include "protocol/artnet_wire.h"

namespace hazer::protocol {
namespace artnet {
namespace {

constexpr std::size_t kDmxHeaderSize = 18;
constexpr std::uint8_t kStartCodeRdm = 0xCC;

// Length is a claim, the datagram is the fact: senders exist that send fewer slots than they say, or more
// than a universe has.
std::span<const std::uint8_t> readSlots(ByteReader& body) {
    const std::size_t claimed = body.u16BigEndian();
    return body.take(std::min({claimed, body.remaining(), kSlotCount}));
}

ArtNetPacket parseDmx(ByteReader body) {
    ArtDmx dmx;
    dmx.sequence = body.u8();
    dmx.physical = body.u8();
    dmx.portAddress = readPortAddress(body);
    dmx.slots = readSlots(body);
    if (body.failed()) return Refusal::kTruncated;
    if (dmx.slots.empty()) return Refusal::kNoSlots;
    return dmx;
}

ArtNetPacket parseNzs(ByteReader body) {
    ArtNzs nzs;
    nzs.sequence = body.u8();
    nzs.startCode = body.u8();
    nzs.portAddress = readPortAddress(body);
    nzs.slots = readSlots(body);
    if (body.failed()) return Refusal::kTruncated;
    if (nzs.startCode == 0 || nzs.startCode == kStartCodeRdm) return Refusal::kBadValue;
    if (nzs.slots.empty()) return Refusal::kNoSlots;
    return nzs;
}

ArtNetPacket parseSync(ByteReader body) {
    body.take(2);  // Aux1, Aux2
    if (body.failed()) return Refusal::kTruncated;
    return ArtSync{};
}

ArtNetPacket parseOfVersion14(std::uint16_t opCode, std::span<const std::uint8_t> body) {
    switch (opCode) {
        case kOpDmx:
            return parseDmx(ByteReader(body));
        case kOpNzs:
            return parseNzs(ByteReader(body));
        case kOpSync:
            return parseSync(ByteReader(body));
        case kOpPoll:
            return parsePoll(body);
        case kOpDiagData:
            return parseDiagData(ByteReader(body));
        case kOpAddress:
            return parseAddress(ByteReader(body));
        case kOpTimeCode:
            return parseTimeCode(ByteReader(body));
        case kOpTrigger:
            return parseTrigger(ByteReader(body));
        case kOpIpProg:
            return parseIpProg(ByteReader(body));
        default:
            return Refusal::kUnusedOpCode;
    }
}

}  // namespace

std::string_view readText(ByteReader& reader, std::size_t fieldSize) {
    const auto field = reader.take(fieldSize);
    const auto end = std::ranges::find(field, std::uint8_t{0});
    return {reinterpret_cast<const char*>(field.data()), static_cast<std::size_t>(end - field.begin())};
}

}  // namespace artnet

ArtNetPacket parseArtNet(std::span<const std::uint8_t> datagram) {
    using namespace artnet;
    ByteReader reader(datagram);
    if (!std::ranges::equal(reader.take(kIdentifier.size()), kIdentifier)) return Refusal::kNotArtNet;
    const std::uint16_t opCode = reader.u16LittleEndian();
    if (reader.failed()) return Refusal::kTruncated;
    // Where other packets have the version, an ArtPollReply has the address of its node.
    if (opCode == kOpPollReply) return parsePollReply(datagram.subspan(kHeaderSize - 2));
    const std::uint16_t version = reader.u16BigEndian();
    if (reader.failed()) return Refusal::kTruncated;
    if (version < kProtocolVersion) return Refusal::kOldVersion;
    return parseOfVersion14(opCode, datagram.subspan(kHeaderSize));
}

std::vector<std::uint8_t> packArtDmx(std::uint16_t portAddress, std::uint8_t sequence,
                                     std::span<const std::uint8_t> slots, std::uint8_t physical) {
    assert(portAddress <= kMaxPortAddress);
    assert(!slots.empty() && slots.size() <= kSlotCount);
    const std::size_t evenCount = slots.size() + slots.size() % 2;
    std::vector<std::uint8_t> datagram(artnet::kDmxHeaderSize + evenCount);
    FieldWriter writer(datagram);
    artnet::writeHeader(writer, artnet::kOpDmx);
    writer.u8(sequence);
    writer.u8(physical);
    writer.u16LittleEndian(portAddress);  // SubUni, then Net
    writer.u16BigEndian(static_cast<std::uint16_t>(evenCount));
    writer.bytes(slots);
    return datagram;
}

std::array<std::uint8_t, kArtSyncSize> packArtSync() {
    std::array<std::uint8_t, kArtSyncSize> datagram{};
    FieldWriter writer(datagram);
    artnet::writeHeader(writer, artnet::kOpSync);
    return datagram;
}

}  // namespace hazer::protocol
