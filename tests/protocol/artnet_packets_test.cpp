// The packets of Art-Net besides ArtDmx, written out byte by byte.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "protocol/artnet.h"
#include "tests/protocol/packets.h"

namespace hazer::protocol {
namespace {

using test::Bytes;
using test::prefixOf;

/// A packet of version 14 with room for `size` bytes, all 0 behind the version.
Bytes packet(std::uint16_t opCode, std::size_t size) {
    Bytes bytes{'A', 'r', 't', '-', 'N', 'e', 't', 0};
    bytes.push_back(static_cast<std::uint8_t>(opCode & 0xFF));
    bytes.push_back(static_cast<std::uint8_t>(opCode >> 8));
    bytes.push_back(0);
    bytes.push_back(14);
    bytes.resize(size);
    return bytes;
}

template <class Packet>
Packet parsed(const Bytes& bytes) {
    const ArtNetPacket result = parseArtNet(bytes);
    EXPECT_TRUE(std::holds_alternative<Packet>(result));
    return std::get<Packet>(result);
}

Refusal refusalOf(const Bytes& bytes) {
    const ArtNetPacket result = parseArtNet(bytes);
    return std::holds_alternative<Refusal>(result) ? std::get<Refusal>(result) : Refusal{0xFF};
}

void put(Bytes& bytes, std::size_t offset, std::string_view text) {
    std::ranges::copy(text, bytes.begin() + static_cast<std::ptrdiff_t>(offset));
}

TEST(ArtNetPackets, EveryPrefixIsRefusedOrTakenWithoutReadingBeyond) {
    struct Kind {
        std::uint16_t opCode;
        std::size_t size;
        std::size_t smallest;  // that is not truncated
    };
    const Kind kinds[] = {{0x2000, 22, 14},   {0x2300, 40, 18}, {0x5100, 60, 18},  {0x5200, 14, 14},
                          {0x6000, 107, 107}, {0x9700, 19, 19}, {0x9900, 530, 18}, {0xF800, 34, 34}};
    for (const Kind& kind : kinds) {
        const Bytes whole = packet(kind.opCode, kind.size);
        for (std::size_t size = 12; size <= whole.size(); ++size) {
            const Bytes prefix = prefixOf(whole, size);
            EXPECT_EQ(refusalOf(prefix) == Refusal::kTruncated, size < kind.smallest)
                << std::hex << kind.opCode << std::dec << " of " << size << " bytes";
        }
    }
}

TEST(ArtPollPackets, FlagsAndTargetGoBothWays) {
    const ArtPoll poll{.wantsChanges = true,
                       .wantsDiagnostics = true,
                       .diagPriority = kDiagMedium,
                       .target = PortAddressRange{3, 0x7FFF}};
    Bytes expected = packet(0x2000, 22);
    put(expected, 12, std::string_view("\x26\x40\x7F\xFF\x00\x03\x7F\xF0\x00\xFF", 10));
    const auto packed = packArtPoll(poll);
    EXPECT_TRUE(std::ranges::equal(packed, expected));
    const auto again = parsed<ArtPoll>(expected);
    EXPECT_TRUE(again.wantsChanges);
    EXPECT_TRUE(again.wantsDiagnostics);
    EXPECT_EQ(again.diagPriority, kDiagMedium);
    EXPECT_EQ(again.target.value().first, 3);
}

TEST(ArtSyncPackets, AreFourteenBytes) {
    EXPECT_TRUE(std::ranges::equal(packArtSync(), packet(0x5200, 14)));
    parsed<ArtSync>(packet(0x5200, 14));
}

TEST(ArtNzsPackets, HaveAStartCodeOfTheirOwn) {
    Bytes nzs = packet(0x5100, 21);
    put(nzs, 12, std::string_view("\x05\x17\x34\x92\x00\x03xyz", 9));
    const auto result = parsed<ArtNzs>(nzs);
    EXPECT_EQ(result.sequence, 5);
    EXPECT_EQ(result.startCode, 0x17);
    EXPECT_EQ(result.portAddress, 0x1234);
    EXPECT_TRUE(std::ranges::equal(result.slots, Bytes{'x', 'y', 'z'}));
    for (const std::uint8_t forbidden : Bytes{0x00, 0xCC}) {
        nzs[13] = forbidden;
        EXPECT_EQ(refusalOf(nzs), Refusal::kBadValue);
    }
}

/// A reply as it would come from a node with two outputs and an input.
Bytes peerReply(std::size_t size = 239) {
    Bytes bytes{'A', 'r', 't', '-', 'N', 'e', 't', 0, 0x00, 0x21, 2, 200, 0, 1};
    bytes.resize(239);
    bytes[18] = 0x12;
    bytes[19] = 0x03;
    put(bytes, 26, "node");
    put(bytes, 44, "a node");
    bytes[173] = 3;
    put(bytes, 174, "\x80\x40\x80");
    put(bytes, 190, "\x04\x05\x06");
    bytes[200] = 1;
    bytes[211] = 2;
    bytes.resize(size);
    return bytes;
}

TEST(ArtPollReplyPackets, OfOthersAreRead) {
    const Bytes bytes = peerReply();
    const auto reply = parsed<PeerPollReply>(bytes);
    EXPECT_EQ(reply.address, (Ipv4Address{2, 200, 0, 1})) << "a second byte above 14 is no old version";
    EXPECT_EQ(reply.shortName, "node");
    EXPECT_EQ(reply.longName, "a node");
    EXPECT_EQ(reply.style, 1);
    EXPECT_EQ(reply.bindIndex, 2);
    EXPECT_EQ(reply.wanted[0], 0x1234);
    EXPECT_EQ(reply.wanted[1], std::nullopt) << "an input";
    EXPECT_EQ(reply.wanted[2], 0x1236);
    EXPECT_EQ(reply.wanted[3], std::nullopt);
}

TEST(ArtPollReplyPackets, OfOlderEditionsAreTaken) {
    for (const std::size_t size : {198U, 207U, 213U, 239U, 300U}) {
        const Bytes bytes = peerReply(size);
        const auto reply = parsed<PeerPollReply>(prefixOf(bytes, size));
        EXPECT_EQ(reply.wanted[0], 0x1234) << size;
        EXPECT_EQ(reply.style, size < 207 ? 0 : 1) << size;
    }
    for (std::size_t size = 10; size < 198; ++size) {
        EXPECT_EQ(refusalOf(prefixOf(peerReply(), size)), Refusal::kTruncated) << size;
    }
}

TEST(ArtPollReplyPackets, MorePortsThanAReplyHasRoomForAreNotRead) {
    Bytes bytes = peerReply();
    bytes[172] = 0xFF;
    const auto reply = parsed<PeerPollReply>(bytes);
    EXPECT_EQ(reply.wanted[2], 0x1236);
}

TEST(ArtPollReplyPackets, NamesWithoutAnEndStopAtTheirField) {
    Bytes bytes = peerReply();
    std::fill(bytes.begin() + 26, bytes.begin() + 108, std::uint8_t{'x'});
    const auto reply = parsed<PeerPollReply>(bytes);
    EXPECT_EQ(reply.shortName.size(), 18U);
    EXPECT_EQ(reply.longName.size(), 64U);
}

TEST(ArtAddressPackets, GoBothWays) {
    Bytes expected = packet(0x6000, 107);
    expected[12] = 0x92;  // Net 0x12, to be programmed
    expected[13] = 4;     // BindIndex
    put(expected, 14, "short");
    put(expected, 32, "long");
    std::fill_n(expected.begin() + 96, 4, std::uint8_t{0x7F});
    put(expected, 100, "\x85\x7F\x7F\x7F");
    expected[104] = 0x7F;
    expected[105] = 255;
    expected[106] = 0x10;
    ArtAddress address;
    address.netSwitch = 0x92;
    address.bindIndex = 4;
    address.shortName = "short";
    address.longName = "long";
    address.swOut[0] = 0x85;
    address.command = AddressCommand::kMergeLatest;
    EXPECT_TRUE(std::ranges::equal(packArtAddress(address), expected));
    const auto again = parsed<ArtAddress>(expected);
    EXPECT_EQ(again.netSwitch, 0x92);
    EXPECT_EQ(again.bindIndex, 4);
    EXPECT_EQ(again.shortName, "short");
    EXPECT_EQ(again.longName, "long");
    EXPECT_EQ(again.swOut[0], 0x85);
    EXPECT_EQ(again.subSwitch, kNoSwitchChange);
    EXPECT_EQ(again.command, AddressCommand::kMergeLatest);
}

TEST(ArtTimeCodePackets, GoBothWays) {
    Bytes expected = packet(0x9700, 19);
    put(expected, 12, std::string_view("\0\0\x18\x3B\x3B\x17\x01", 7));
    const ArtTimeCode code{
        .hours = 23, .minutes = 59, .seconds = 59, .frames = 24, .type = TimeCodeType::kEbu25};
    EXPECT_TRUE(std::ranges::equal(packArtTimeCode(code), expected));
    const auto again = parsed<ArtTimeCode>(expected);
    EXPECT_EQ(again.hours, 23);
    EXPECT_EQ(again.frames, 24);
    EXPECT_NEAR(again.timeS(), 86400.0 - 0.04, 1e-9);
}

TEST(ArtTimeCodePackets, TimesThatDoNotExistAreBroken) {
    const auto refuses = [](std::uint8_t hours, std::uint8_t minutes, std::uint8_t seconds,
                            std::uint8_t frames, std::uint8_t type) {
        Bytes bytes = packet(0x9700, 19);
        bytes[14] = frames;
        bytes[15] = seconds;
        bytes[16] = minutes;
        bytes[17] = hours;
        bytes[18] = type;
        return refusalOf(bytes) == Refusal::kBadValue;
    };
    EXPECT_TRUE(refuses(24, 0, 0, 0, 1));
    EXPECT_TRUE(refuses(0, 60, 0, 0, 1));
    EXPECT_TRUE(refuses(0, 0, 60, 0, 1));
    EXPECT_TRUE(refuses(0, 0, 0, 24, 0));
    EXPECT_FALSE(refuses(0, 0, 0, 23, 0));
    EXPECT_TRUE(refuses(0, 0, 0, 25, 1));
    EXPECT_TRUE(refuses(0, 0, 0, 30, 3));
    EXPECT_FALSE(refuses(0, 0, 0, 29, 3));
    EXPECT_TRUE(refuses(0, 0, 0, 0, 4));
    EXPECT_TRUE(refuses(0, 1, 0, 1, 2)) << "dropped";
    EXPECT_FALSE(refuses(0, 1, 0, 2, 2));
    EXPECT_FALSE(refuses(0, 10, 0, 0, 2));
    EXPECT_FALSE(refuses(0, 1, 1, 0, 2));
}

TEST(ArtTimeCodePackets, DropFrameKeepsStepWithTheClock) {
    ArtTimeCode code;
    code.type = TimeCodeType::kDropFrame2997;
    code.minutes = 1;
    code.frames = 2;
    EXPECT_NEAR(code.timeS(), 1800 * 1001.0 / 30000.0, 1e-9) << "the frame after 0:00:59:29";
    code = {.hours = 1, .type = TimeCodeType::kDropFrame2997};
    EXPECT_NEAR(code.timeS(), 3600.0, 0.01);
}

TEST(ArtTriggerPackets, GoBothWays) {
    Bytes expected = packet(0x9900, 530);
    put(expected, 14,
        std::string_view("\xFF\xFF\x03\x07"
                         "ab",
                         6));
    const Bytes data{'a', 'b'};
    const auto packed = packArtTrigger({.key = 3, .subKey = 7, .data = data});
    EXPECT_EQ(packed, expected);
    const auto again = parsed<ArtTrigger>(expected);
    EXPECT_EQ(again.oem, kOemEverybody);
    EXPECT_EQ(again.key, 3);
    EXPECT_EQ(again.subKey, 7);
    EXPECT_EQ(again.data.size(), 512U);
    expected.resize(2000);
    EXPECT_EQ(parsed<ArtTrigger>(expected).data.size(), 512U);
}

TEST(ArtDiagDataPackets, GoBothWays) {
    Bytes expected = packet(0x2300, 21);
    expected[13] = 0x40;
    expected[17] = 3;
    put(expected, 18, "hi");
    EXPECT_EQ(packArtDiagData({.priority = kDiagMedium, .text = "hi"}), expected);
    EXPECT_EQ(parsed<ArtDiagData>(expected).text, "hi");
    expected[16] = 0xFF;  // claims more than there is
    EXPECT_EQ(parsed<ArtDiagData>(expected).text, "hi");
    EXPECT_EQ(packArtDiagData({.text = std::string(9999, 'x')}).size(), 18U + 512U);
}

TEST(ArtIpProgReplyPackets, TellTheAddressAsItStands) {
    Bytes expected = packet(0xF900, 34);
    put(expected, 16, "\x0A\x01\x02\x03");
    EXPECT_TRUE(std::ranges::equal(packArtIpProgReply({10, 1, 2, 3}), expected));
}

}  // namespace
}  // namespace hazer::protocol
