#include "protocol/artnet_poll.h"

#include <algorithm>
#include <cassert>

#include "protocol/artnet_parsers.h"
#include "protocol/artnet_wire.h"

namespace hazer::protocol {
namespace artnet {
namespace {

constexpr std::size_t kMinPollBodySize = 2;  // the polls of Art-Net 3, which many desks still send
constexpr std::uint8_t kPollFlagChanges = 1U << 1;
constexpr std::uint8_t kPollFlagDiagnostics = 1U << 2;
constexpr std::uint8_t kPollFlagTargeted = 1U << 5;

constexpr std::size_t kReplyBodyOffset = 10;
constexpr std::size_t kMinReplySize = 198;  // before Art-Net 3

constexpr std::uint16_t kFirmwareVersion = 1;
// OemUnknown of the Art-Net OEM list: hazer has no code of its own
constexpr std::uint16_t kOemUnknown = 0x00FF;
// first of the manufacturer codes that ESTA keeps for prototypes
constexpr std::uint16_t kEstaPrototype = 0x7FF0;
constexpr std::uint8_t kStatus1AddressedHere = 1U << 4;  // Port-Addresses set at the machine itself
constexpr std::uint8_t kStatus1AddressedByNetwork = 2U << 4;
constexpr std::uint8_t kPortTypeOutputDmx = 0x80;  // takes DMX512 from Art-Net
constexpr std::uint8_t kGoodOutputReceiving = 1U << 7;
constexpr std::uint8_t kGoodOutputMerging = 1U << 3;
constexpr std::uint8_t kGoodOutputLatest = 1U << 1;
constexpr std::uint8_t kDefaultSacnPriority = 100;     // the default of ANSI E1.31
constexpr std::uint8_t kStyleVisualizer = 6;           // StVisual
constexpr std::uint8_t kStatus2LongAddress = 1U << 3;  // understands 15-bit Port-Addresses
constexpr std::uint16_t kRefreshRateHz = 44;           // a full DMX512 universe

constexpr std::size_t kDiagHeaderSize = 18;
constexpr std::size_t kMaxDiagText = 512;  // with its NUL

std::uint8_t goodOutputOf(const ArtPollReply& reply) {
    return static_cast<std::uint8_t>((reply.isReceiving ? kGoodOutputReceiving : 0) |
                                     (reply.isMerging ? kGoodOutputMerging : 0) |
                                     (reply.mergesLatest ? kGoodOutputLatest : 0));
}

std::uint8_t status1Of(const ArtPollReply& reply) {
    const auto indicators = static_cast<std::uint8_t>(static_cast<std::uint8_t>(reply.indicators) << 6);
    return indicators | (reply.isProgrammable ? kStatus1AddressedByNetwork : kStatus1AddressedHere);
}

// NumPorts to SwOut: the part that makes a desk unicast ArtDmx to us.
void writePorts(FieldWriter& writer, const ArtPollReply& reply) {
    const bool hasPort = reply.portAddress.has_value();
    writer.u16BigEndian(hasPort ? 1 : 0);             // NumPorts
    writer.u8(hasPort ? kPortTypeOutputDmx : 0);      // PortTypes[0]
    writer.skip(3);                                   // PortTypes[1..3]
    writer.skip(4);                                   // GoodInput
    writer.u8(hasPort ? goodOutputOf(reply) : 0);     // GoodOutputA[0]
    writer.skip(3);                                   // GoodOutputA[1..3]
    writer.skip(4);                                   // SwIn
    writer.u8(reply.portAddress.value_or(0) & 0x0F);  // SwOut[0]
    writer.skip(3);                                   // SwOut[1..3]
}

}  // namespace

ArtNetPacket parsePoll(std::span<const std::uint8_t> body) {
    if (body.size() < kMinPollBodySize) return Refusal::kTruncated;
    // Fields that an older poll does not have are 0.
    std::array<std::uint8_t, kArtPollSize - kHeaderSize> padded{};
    std::copy_n(body.begin(), std::min(body.size(), padded.size()), padded.begin());
    ByteReader fields{padded};
    const std::uint8_t flags = fields.u8();
    ArtPoll poll;
    poll.wantsChanges = flags & kPollFlagChanges;
    poll.wantsDiagnostics = flags & kPollFlagDiagnostics;
    poll.diagPriority = fields.u8();
    const std::uint16_t top = fields.u16BigEndian();
    const std::uint16_t bottom = fields.u16BigEndian();
    if (flags & kPollFlagTargeted) poll.target = PortAddressRange{bottom, top};
    return poll;
}

ArtNetPacket parsePollReply(std::span<const std::uint8_t> body) {
    if (body.size() + kReplyBodyOffset < kMinReplySize) return Refusal::kTruncated;
    ByteReader fields{body};
    PeerPollReply reply;
    std::ranges::copy(fields.take(4), reply.address.begin());
    fields.take(4);  // Port, VersInfo
    const auto net = static_cast<std::uint8_t>(fields.u8() & kNetMask);
    const auto subNet = static_cast<std::uint8_t>(fields.u8() & 0x0F);
    fields.take(6);  // Oem, UbeaVersion, Status1, EstaMan
    reply.shortName = readText(fields, 18);
    reply.longName = readText(fields, 64);
    fields.take(64);  // NodeReport
    const std::size_t portCount = std::min<std::size_t>(fields.u16BigEndian(), reply.wanted.size());
    const auto portTypes = fields.take(4);
    fields.take(12);  // GoodInput, GoodOutputA, SwIn
    const auto swOut = fields.take(4);
    for (std::size_t i = 0; i < portCount; ++i) {
        if (!(portTypes[i] & kPortTypeOutputDmx)) continue;
        reply.wanted[i] = static_cast<std::uint16_t>(net << 8 | subNet << 4 | (swOut[i] & 0x0F));
    }
    fields.take(6);  // AcnPriority, SwMacro, SwRemote, spare
    reply.style = fields.u8();
    fields.take(10);  // MAC, BindIp
    reply.bindIndex = fields.u8();
    return reply;  // what an older reply does not have was read as 0
}

ArtNetPacket parseDiagData(ByteReader body) {
    ArtDiagData message;
    body.u8();  // filler
    message.priority = body.u8();
    message.logicalPort = body.u8();
    body.u8();  // filler
    const std::size_t claimed = body.u16BigEndian();
    if (body.failed()) return Refusal::kTruncated;
    message.text = readText(body, std::min({claimed, body.remaining(), kMaxDiagText}));
    return message;
}

}  // namespace artnet

std::array<std::uint8_t, kArtPollSize> packArtPoll(const ArtPoll& poll) {
    using namespace artnet;
    std::array<std::uint8_t, kArtPollSize> datagram{};
    FieldWriter writer(datagram);
    writeHeader(writer, kOpPoll);
    writer.u8(static_cast<std::uint8_t>((poll.wantsChanges ? kPollFlagChanges : 0) |
                                        (poll.wantsDiagnostics ? kPollFlagDiagnostics : 0) |
                                        (poll.target ? kPollFlagTargeted : 0)));
    writer.u8(poll.diagPriority);
    const PortAddressRange target = poll.target.value_or(PortAddressRange{0, 0});
    writer.u16BigEndian(target.last);
    writer.u16BigEndian(target.first);
    writer.u16BigEndian(kEstaPrototype);
    writer.u16BigEndian(kOemUnknown);
    return datagram;
}

ArtPollReplyBytes packArtPollReply(const ArtPollReply& reply) {
    using namespace artnet;
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
    writer.u8(status1Of(reply));
    writer.u16LittleEndian(kEstaPrototype);
    writer.text(reply.shortName, 18);
    writer.text(reply.longName, 64);
    writer.text(reply.nodeReport, 64);
    writePorts(writer, reply);
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

std::vector<std::uint8_t> packArtDiagData(const ArtDiagData& message) {
    using namespace artnet;
    const std::size_t textSize = std::min(message.text.size() + 1, kMaxDiagText);
    std::vector<std::uint8_t> datagram(kDiagHeaderSize + textSize);
    FieldWriter writer(datagram);
    writeHeader(writer, kOpDiagData);
    writer.skip(1);
    writer.u8(message.priority);
    writer.u8(message.logicalPort);
    writer.skip(1);
    writer.u16BigEndian(static_cast<std::uint16_t>(textSize));
    writer.text(message.text, textSize);
    return datagram;
}

}  // namespace hazer::protocol
