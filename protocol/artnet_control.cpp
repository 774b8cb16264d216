#include "protocol/artnet_control.h"

#include <algorithm>

#include "protocol/artnet_parsers.h"
#include "protocol/artnet_wire.h"

namespace hazer::protocol {
namespace artnet {
namespace {

constexpr std::size_t kTriggerHeaderSize = 18;
constexpr std::size_t kTriggerDataSize = 512;

int framesPerSecond(TimeCodeType type) {
    switch (type) {
        case TimeCodeType::kFilm24:
            return 24;
        case TimeCodeType::kEbu25:
            return 25;
        case TimeCodeType::kDropFrame2997:
        case TimeCodeType::kSmpte30:
            break;
    }
    return 30;
}

// Drop frame leaves out the numbers 0 and 1 at the start of each minute, but not of each tenth one.
bool isDropped(const ArtTimeCode& code) {
    return code.type == TimeCodeType::kDropFrame2997 && code.frames < 2 && code.seconds == 0 &&
           code.minutes % 10 != 0;
}

bool isValid(const ArtTimeCode& code) {
    return code.hours < 24 && code.minutes < 60 && code.seconds < 60 &&
           code.frames < framesPerSecond(code.type) && !isDropped(code);
}

}  // namespace

ArtNetPacket parseAddress(ByteReader body) {
    ArtAddress address;
    address.netSwitch = body.u8();
    address.bindIndex = body.u8();
    address.shortName = readText(body, 18);
    address.longName = readText(body, 64);
    body.take(4);  // SwIn: we have no inputs
    const auto swOut = body.take(4);
    std::ranges::copy(swOut, address.swOut.begin());
    address.subSwitch = body.u8();
    body.u8();  // AcnPriority: we send no sACN
    address.command = static_cast<AddressCommand>(body.u8());
    if (body.failed()) return Refusal::kTruncated;
    return address;
}

ArtNetPacket parseIpProg(ByteReader body) {
    body.take(kArtIpProgReplySize - kHeaderSize);
    if (body.failed()) return Refusal::kTruncated;
    return ArtIpProg{};
}

ArtNetPacket parseTimeCode(ByteReader body) {
    ArtTimeCode code;
    body.u8();  // filler
    code.streamId = body.u8();
    code.frames = body.u8();
    code.seconds = body.u8();
    code.minutes = body.u8();
    code.hours = body.u8();
    const std::uint8_t type = body.u8();
    if (body.failed()) return Refusal::kTruncated;
    if (type > static_cast<std::uint8_t>(TimeCodeType::kSmpte30)) return Refusal::kBadValue;
    code.type = static_cast<TimeCodeType>(type);
    if (!isValid(code)) return Refusal::kBadValue;
    return code;
}

ArtNetPacket parseTrigger(ByteReader body) {
    ArtTrigger trigger;
    body.take(2);  // filler
    trigger.oem = body.u16BigEndian();
    trigger.key = body.u8();
    trigger.subKey = body.u8();
    if (body.failed()) return Refusal::kTruncated;
    trigger.data = body.take(std::min(body.remaining(), kTriggerDataSize));
    return trigger;
}

}  // namespace artnet

double ArtTimeCode::timeS() const {
    const int minutesSinceMidnight = hours * 60 + minutes;
    const int rate = artnet::framesPerSecond(type);
    long count = (minutesSinceMidnight * 60L + seconds) * rate + frames;
    if (type != TimeCodeType::kDropFrame2997) return static_cast<double>(count) / rate;
    count -= 2L * (minutesSinceMidnight - minutesSinceMidnight / 10);
    return static_cast<double>(count) * 1001.0 / 30000.0;
}

std::array<std::uint8_t, kArtAddressSize> packArtAddress(const ArtAddress& address) {
    std::array<std::uint8_t, kArtAddressSize> datagram{};
    FieldWriter writer(datagram);
    artnet::writeHeader(writer, artnet::kOpAddress);
    writer.u8(address.netSwitch);
    writer.u8(address.bindIndex);
    writer.text(address.shortName, 18);
    writer.text(address.longName, 64);
    for (int i = 0; i < 4; ++i) writer.u8(kNoSwitchChange);  // SwIn
    writer.bytes(address.swOut);
    writer.u8(address.subSwitch);
    writer.u8(255);  // AcnPriority: no change
    writer.u8(static_cast<std::uint8_t>(address.command));
    return datagram;
}

std::array<std::uint8_t, kArtIpProgReplySize> packArtIpProgReply(Ipv4Address ownAddress) {
    std::array<std::uint8_t, kArtIpProgReplySize> datagram{};
    FieldWriter writer(datagram);
    artnet::writeHeader(writer, artnet::kOpIpProgReply);
    writer.skip(4);
    writer.bytes(ownAddress);
    return datagram;
}

std::array<std::uint8_t, kArtTimeCodeSize> packArtTimeCode(const ArtTimeCode& code) {
    std::array<std::uint8_t, kArtTimeCodeSize> datagram{};
    FieldWriter writer(datagram);
    artnet::writeHeader(writer, artnet::kOpTimeCode);
    writer.skip(1);
    writer.u8(code.streamId);
    writer.u8(code.frames);
    writer.u8(code.seconds);
    writer.u8(code.minutes);
    writer.u8(code.hours);
    writer.u8(static_cast<std::uint8_t>(code.type));
    return datagram;
}

std::vector<std::uint8_t> packArtTrigger(const ArtTrigger& trigger) {
    using namespace artnet;
    std::vector<std::uint8_t> datagram(kTriggerHeaderSize + kTriggerDataSize);
    FieldWriter writer(datagram);
    writeHeader(writer, kOpTrigger);
    writer.skip(2);
    writer.u16BigEndian(trigger.oem);
    writer.u8(trigger.key);
    writer.u8(trigger.subKey);
    writer.bytes(trigger.data.first(std::min(trigger.data.size(), kTriggerDataSize)));
    return datagram;
}

}  // namespace hazer::protocol
