#include "protocol/artnet.h"

#include <algorithm>
#include <cassert>

#include "protocol/byte_reader.h"
#include "protocol/field_writer.h"

namespace hazer::protocol {
namespace {

constexpr std::array<std::uint8_t, 8> kIdentifier{'A', 'r', 't', '-', 'N', 'e', 't', 0};
constexpr std::uint16_t kOpPoll = 0x2000;
constexpr std::uint16_t kOpPollReply = 0x2100;
constexpr std::uint16_t kOpDmx = 0x5000;
constexpr std::uint16_t kProtocolVersion = 14;

constexpr std::size_t kDmxHeaderSize = 18;
constexpr std::size_t kPollSize = 22;
constexpr std::size_t kMinPollSize = 14;  // the polls of Art-Net 3, which many desks still send
constexpr std::size_t kPollFieldsOffset = 12;
constexpr std::uint8_t kPollFlagTargeted = 1U << 5;

// The high byte of a Port-Address on the wire has 7 bits; the eighth belongs to nobody and is not trusted to
// be 0.
constexpr std::uint8_t kNetMask = 0x7F;

bool isOfCurrentVersion(ByteReader& reader) {
    return reader.u16BigEndian() >= kProtocolVersion;
}

ArtNetPacket parseDmx(ByteReader& reader) {
    if (!isOfCurrentVersion(reader)) return reader.failed() ? Refusal::kTruncated : Refusal::kOldVersion;
    ArtDmx dmx;
    dmx.sequence = reader.u8();
    dmx.physical = reader.u8();
    const std::uint8_t subUni = reader.u8();
    const auto net = static_cast<std::uint8_t>(reader.u8() & kNetMask);
    dmx.portAddress = static_cast<std::uint16_t>(net << 8 | subUni);
    const std::size_t claimed = reader.u16BigEndian();
    if (reader.failed()) return Refusal::kTruncated;
    // Length is a claim, the datagram is the fact: senders exist that send fewer slots than they say, or more
    // than a universe has.
    dmx.slots = reader.take(std::min({claimed, reader.remaining(), kSlotCount}));
    if (dmx.slots.empty()) return Refusal::kNoSlots;
    return dmx;
}

ArtNetPacket parsePoll(ByteReader& reader, std::span<const std::uint8_t> datagram) {
    if (!isOfCurrentVersion(reader)) return reader.failed() ? Refusal::kTruncated : Refusal::kOldVersion;
    if (datagram.size() < kMinPollSize) return Refusal::kTruncated;
    // Fields that an older poll does not have are 0.
    std::array<std::uint8_t, kPollSize> padded{};
    std::copy_n(datagram.begin(), std::min(datagram.size(), kPollSize), padded.begin());
    ByteReader fields{std::span(padded).subspan(kPollFieldsOffset)};
    const std::uint8_t flags = fields.u8();
    fields.u8();  // DiagPriority: we send no diagnostics
    const std::uint16_t top = fields.u16BigEndian();
    const std::uint16_t bottom = fields.u16BigEndian();
    ArtPoll poll;
    if (flags & kPollFlagTargeted) poll.target = PortAddressRange{bottom, top};
    return poll;
}

constexpr std::uint16_t kFirmwareVersion = 1;
constexpr std::uint16_t kOemUnknown =
    0x00FF;  // OemUnknown of the Art-Net OEM list: hazer has no code of its own
constexpr std::uint16_t kEstaPrototype =
    0x7FF0;  // first of the manufacturer codes that ESTA keeps for prototypes
constexpr std::uint8_t kStatus1Normal = 0b11010000;  // indicators normal, addresses set at the machine itself
constexpr std::uint8_t kPortTypeOutputDmx = 0x80;    // takes DMX512 from Art-Net
constexpr std::uint8_t kDefaultSacnPriority = 100;   // the default of ANSI E1.31
constexpr std::uint8_t kStyleVisualizer = 6;         // StVisual
constexpr std::uint8_t kStatus2LongAddress = 1U << 3;  // understands 15-bit Port-Addresses
constexpr std::uint16_t kRefreshRateHz = 44;           // a full DMX512 universe

// NumPorts to SwOut: the part that makes a desk unicast ArtDmx to us.
void writePorts(FieldWriter& writer, std::optional<std::uint16_t> portAddress) {
    writer.u16BigEndian(portAddress ? 1 : 0);         // NumPorts
    writer.u8(portAddress ? kPortTypeOutputDmx : 0);  // PortTypes[0]
    writer.skip(3);                                   // PortTypes[1..3]
    writer.skip(4);                                   // GoodInput
    writer.skip(4);                                   // GoodOutputA
    writer.skip(4);                                   // SwIn
    writer.u8(portAddress.value_or(0) & 0x0F);        // SwOut[0]
    writer.skip(3);                                   // SwOut[1..3]
}

}  // namespace

ArtNetPacket parseArtNet(std::span<const std::uint8_t> datagram) {
    ByteReader reader(datagram);
    if (!std::ranges::equal(reader.take(kIdentifier.size()), kIdentifier)) return Refusal::kNotArtNet;
    const std::uint16_t opCode = reader.u16LittleEndian();
    if (reader.failed()) return Refusal::kTruncated;
    switch (opCode) {
        case kOpDmx:
            return parseDmx(reader);
        case kOpPoll:
            return parsePoll(reader, datagram);
        default:
            return Refusal::kUnusedOpCode;
    }
}

std::vector<std::uint8_t> packArtDmx(std::uint16_t portAddress, std::uint8_t sequence,
                                     std::span<const std::uint8_t> slots) {
    assert(portAddress <= kMaxPortAddress);
    assert(!slots.empty() && slots.size() <= kSlotCount);
    const std::size_t evenCount = slots.size() + slots.size() % 2;
    std::vector<std::uint8_t> datagram(kDmxHeaderSize + evenCount);
    FieldWriter writer(datagram);
    writer.bytes(kIdentifier);
    writer.u16LittleEndian(kOpDmx);
    writer.u16BigEndian(kProtocolVersion);
    writer.u8(sequence);
    writer.skip(1);                       // Physical
    writer.u16LittleEndian(portAddress);  // SubUni, then Net
    writer.u16BigEndian(static_cast<std::uint16_t>(evenCount));
    writer.bytes(slots);
    return datagram;
}

ArtPollReplyBytes packArtPollReply(const ArtPollReply& reply) {
    const std::uint16_t portAddress = reply.portAddress.value_or(0);
    assert(portAddress <= kMaxPortAddress);
    ArtPollReplyBytes datagram{};
    FieldWriter writer(datagram);
    writer.bytes(kIdentifier);
    writer.u16LittleEndian(kOpPollReply);
    writer.bytes(reply.ownAddress);
    writer.u16LittleEndian(kArtNetPort);
    writer.u16BigEndian(kFirmwareVersion);
    writer.u8(static_cast<std::uint8_t>(portAddress >> 8));           // NetSwitch
    writer.u8(static_cast<std::uint8_t>((portAddress >> 4) & 0x0F));  // SubSwitch
    writer.u16BigEndian(kOemUnknown);
    writer.skip(1);  // UbeaVersion
    writer.u8(kStatus1Normal);
    writer.u16LittleEndian(kEstaPrototype);
    writer.text(reply.shortName, 18);
    writer.text(reply.longName, 64);
    writer.text(reply.nodeReport, 64);
    writePorts(writer, reply.portAddress);
    writer.u8(kDefaultSacnPriority);
    writer.skip(5);  // SwMacro, SwRemote, spare
    writer.u8(kStyleVisualizer);
    writer.skip(6);                  // MAC
    writer.bytes(reply.ownAddress);  // BindIp: we are our own root device
    writer.u8(reply.bindIndex);
    writer.u8(kStatus2LongAddress);
    writer.skip(13);  // GoodOutputB, Status3 (0: hold the last look when data stops), DefaultRespUID, User
    writer.u16BigEndian(kRefreshRateHz);
    return datagram;
}

}  // namespace hazer::protocol
