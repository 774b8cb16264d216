#include "protocol/artnet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>

#include "tests/protocol/packets.h"

namespace hazer::protocol {
namespace {

using test::Bytes;
using test::dmxDatagram;
using test::pollDatagram;
using test::prefixOf;

Refusal refusalOf(std::span<const std::uint8_t> datagram) {
    const ArtNetPacket packet = parseArtNet(datagram);
    EXPECT_TRUE(std::holds_alternative<Refusal>(packet));
    return std::get<Refusal>(packet);
}

Bytes slotsOf(std::span<const std::uint8_t> datagram) {
    const ArtNetPacket packet = parseArtNet(datagram);
    const auto* dmx = std::get_if<ArtDmx>(&packet);
    return dmx ? Bytes(dmx->slots.begin(), dmx->slots.end()) : Bytes{};
}

TEST(ArtDmxParsing, ReadsEveryField) {
    const Bytes datagram =
        dmxDatagram({.sequence = 7, .physical = 2, .subUni = 0x34, .net = 0x12, .slots = {9, 8, 7, 6}});
    const ArtNetPacket packet = parseArtNet(datagram);
    ASSERT_TRUE(std::holds_alternative<ArtDmx>(packet));
    const auto& dmx = std::get<ArtDmx>(packet);
    EXPECT_EQ(dmx.sequence, 7);
    EXPECT_EQ(dmx.physical, 2);
    EXPECT_EQ(dmx.portAddress, 0x1234);
    EXPECT_TRUE(std::ranges::equal(dmx.slots, Bytes{9, 8, 7, 6}));
}

TEST(ArtDmxParsing, EveryPrefixIsRefusedOrTakenWithTheSlotsThatAreThere) {
    const Bytes whole = dmxDatagram({.slots = {11, 12, 13, 14}});
    for (std::size_t size = 0; size <= whole.size(); ++size) {
        SCOPED_TRACE(size);
        const Bytes prefix = prefixOf(whole, size);
        if (size < 8) {
            EXPECT_EQ(refusalOf(prefix), Refusal::kNotArtNet);
        } else if (size < 18) {
            EXPECT_EQ(refusalOf(prefix), Refusal::kTruncated);
        } else if (size == 18) {
            EXPECT_EQ(refusalOf(prefix), Refusal::kNoSlots);
        } else {
            EXPECT_EQ(slotsOf(prefix),
                      Bytes(whole.begin() + 18, whole.begin() + static_cast<std::ptrdiff_t>(size)));
        }
    }
}

TEST(ArtDmxParsing, LengthIsAClaimThatTheDatagramAndTheUniverseLimit) {
    struct Case {
        std::uint16_t claimed;
        std::size_t sent;
        std::size_t taken;
    };
    const Case cases[] = {
        {1, 1, 1},       {3, 3, 3},       {511, 511, 511},     {512, 512, 512},  // honest, odd and even
        {2, 10, 2},      {511, 512, 511},                                        // says less than it sends
        {512, 2, 2},     {0xFFFF, 4, 4},  {0x0200, 511, 511},                    // says more than it sends
        {514, 514, 512}, {600, 600, 512}, {0xFFFF, 1400, 512},                   // more than a universe
    };
    for (const Case& c : cases) {
        SCOPED_TRACE(testing::Message() << c.claimed << " claimed, " << c.sent << " sent");
        Bytes slots(c.sent);
        std::iota(slots.begin(), slots.end(), std::uint8_t{1});
        const Bytes datagram = dmxDatagram({.claimedLength = c.claimed, .slots = slots});
        EXPECT_EQ(slotsOf(datagram), prefixOf(slots, c.taken));
    }
}

TEST(ArtDmxParsing, NoSlotsIsItsOwnRefusal) {
    EXPECT_EQ(refusalOf(dmxDatagram({.claimedLength = 0, .slots = {1, 2}})), Refusal::kNoSlots);
    EXPECT_EQ(refusalOf(dmxDatagram({.claimedLength = 512, .slots = {}})), Refusal::kNoSlots);
}

TEST(ArtDmxParsing, EveryPortAddressMapsToItself) {
    for (unsigned portAddress = 0; portAddress <= kMaxPortAddress; ++portAddress) {
        for (const unsigned strayBit : {0U, 0x80U}) {
            const Bytes datagram =
                dmxDatagram({.subUni = static_cast<std::uint8_t>(portAddress & 0xFF),
                             .net = static_cast<std::uint8_t>((portAddress >> 8) | strayBit)});
            ASSERT_EQ(std::get<ArtDmx>(parseArtNet(datagram)).portAddress, portAddress);
        }
    }
}

TEST(ArtNetParsing, VersionBelow14IsRefusedAndAboveTaken) {
    Bytes dmx = dmxDatagram({});
    Bytes poll = pollDatagram();
    for (Bytes* datagram : {&dmx, &poll}) {
        (*datagram)[11] = 13;
        EXPECT_EQ(refusalOf(*datagram), Refusal::kOldVersion);
        (*datagram)[11] = 15;
        EXPECT_FALSE(std::holds_alternative<Refusal>(parseArtNet(*datagram)));
        (*datagram)[10] = 1;  // version 256 + 0
        (*datagram)[11] = 0;
        EXPECT_FALSE(std::holds_alternative<Refusal>(parseArtNet(*datagram)));
    }
}

TEST(ArtNetParsing, OtherPacketsAreUnusedAndNotBroken) {
    Bytes datagram = pollDatagram();
    for (const std::uint8_t highOpCode : Bytes{0x24, 0x27, 0x70, 0x80, 0x83, 0x98, 0x9A, 0xF2, 0xF9, 0xFF}) {
        datagram[9] = highOpCode;
        EXPECT_EQ(refusalOf(datagram), Refusal::kUnusedOpCode);
    }
    datagram[8] = 0x50;  // ArtDmx with the bytes of its opcode exchanged
    datagram[9] = 0x00;
    EXPECT_EQ(refusalOf(datagram), Refusal::kUnusedOpCode);
}

TEST(ArtNetParsing, EveryByteOfTheIdentifierCounts) {
    for (std::size_t i = 0; i < 8; ++i) {
        Bytes datagram = dmxDatagram({});
        datagram[i] ^= 0x20;
        EXPECT_EQ(refusalOf(datagram), Refusal::kNotArtNet) << i;
    }
}

TEST(ArtPollParsing, EveryPrefixFrom14BytesIsTaken) {
    const Bytes whole = pollDatagram();
    for (std::size_t size = 8; size <= whole.size(); ++size) {
        SCOPED_TRACE(size);
        const Bytes prefix = prefixOf(whole, size);
        if (size < 14) {
            EXPECT_EQ(refusalOf(prefix), Refusal::kTruncated);
        } else {
            EXPECT_FALSE(std::get<ArtPoll>(parseArtNet(prefix)).target);
        }
    }
}

TEST(ArtPollParsing, ReadsTheTargetAndTakesMissingBytesForZero) {
    const Bytes whole = test::targetedPollDatagram(0x0102, 0x7FFE);
    const ArtPoll poll = std::get<ArtPoll>(parseArtNet(whole));
    ASSERT_TRUE(poll.target);
    EXPECT_EQ(poll.target->first, 0x0102);
    EXPECT_EQ(poll.target->last, 0x7FFE);

    const Bytes prefix = prefixOf(whole, 17);
    const ArtPoll cut = std::get<ArtPoll>(parseArtNet(prefix));
    ASSERT_TRUE(cut.target);
    EXPECT_EQ(cut.target->first, 0x0100);
    EXPECT_EQ(cut.target->last, 0x7FFE);
}

TEST(ArtDmxPacking, WritesTheBytesOfTheStandard) {
    const Bytes expected = dmxDatagram({.sequence = 255, .subUni = 0xFF, .net = 0x7F, .slots = {5, 6}});
    EXPECT_EQ(packArtDmx(kMaxPortAddress, 255, Bytes{5, 6}), expected);
}

TEST(ArtDmxPacking, PadsAnOddCountWithZero) {
    EXPECT_EQ(packArtDmx(0, 1, Bytes{5}), dmxDatagram({.sequence = 1, .slots = {5, 0}}));
    EXPECT_EQ(packArtDmx(0, 1, Bytes(511, 3)).size(), 18U + 512U);
    EXPECT_EQ(packArtDmx(0, 1, Bytes(512, 3)).size(), 18U + 512U);
}

void put(ArtPollReplyBytes& datagram, std::size_t offset, std::string_view bytes) {
    std::ranges::copy(bytes, datagram.begin() + static_cast<std::ptrdiff_t>(offset));
}

TEST(ArtPollReplyPacking, WritesEveryFieldAtItsOffset) {
    ArtPollReplyBytes expected{};
    put(expected, 0, std::string_view("Art-Net\0\x00\x21", 10));
    put(expected, 10, "\x02\xC8\x07\x01");               // IpAddress
    put(expected, 14, "\x36\x19");                       // Port 6454, low byte first
    put(expected, 16, std::string_view("\x00\x01", 2));  // VersInfo
    expected[18] = 0x12;                                 // NetSwitch
    expected[19] = 0x03;                                 // SubSwitch
    put(expected, 20, std::string_view("\x00\xFF", 2));  // Oem
    expected[23] = 0xD0;                                 // Status1
    put(expected, 24, "\xF0\x7F");                       // EstaMan, low byte first
    put(expected, 26, "short");
    put(expected, 44, "long");
    put(expected, 108, "#0001 [0000] fine");
    expected[173] = 1;                       // NumPorts
    expected[174] = 0x80;                    // PortTypes: output from Art-Net
    expected[190] = 0x04;                    // SwOut
    expected[194] = 100;                     // AcnPriority
    expected[200] = 6;                       // Style: visualizer
    put(expected, 207, "\x02\xC8\x07\x01");  // BindIp
    expected[211] = 9;                       // BindIndex
    expected[212] = 0x08;                    // Status2: 15-bit Port-Addresses
    expected[227] = 44;                      // RefreshRate

    const ArtPollReplyBytes reply = packArtPollReply({.ownAddress = {2, 200, 7, 1},
                                                      .portAddress = 0x1234,
                                                      .bindIndex = 9,
                                                      .shortName = "short",
                                                      .longName = "long",
                                                      .nodeReport = "#0001 [0000] fine"});
    for (std::size_t i = 0; i < reply.size(); ++i)
        EXPECT_EQ(int{reply[i]}, int{expected[i]}) << "offset " << i;
}

TEST(ArtPollReplyPacking, SplitsTheHighestPortAddress) {
    const ArtPollReplyBytes reply = packArtPollReply({.portAddress = kMaxPortAddress});
    EXPECT_EQ(reply[18], 0x7F);
    EXPECT_EQ(reply[19], 0x0F);
    EXPECT_EQ(reply[190], 0x0F);
}

TEST(ArtPollReplyPacking, ANodeWithoutPortsHasNone) {
    const ArtPollReplyBytes reply = packArtPollReply({});
    EXPECT_EQ(reply[173], 0);
    EXPECT_EQ(reply[174], 0);
}

TEST(ArtPollReplyPacking, CutsLongNamesBeforeTheirNul) {
    const std::string endless(300, 'x');
    const ArtPollReplyBytes reply =
        packArtPollReply({.shortName = endless, .longName = endless, .nodeReport = endless});
    for (const auto& [first, end] : {std::pair{26, 44}, {44, 108}, {108, 172}}) {
        EXPECT_EQ(std::count(reply.begin() + first, reply.begin() + end, 'x'), end - first - 1);
        EXPECT_EQ(reply[static_cast<std::size_t>(end) - 1], 0);
    }
}

}  // namespace
}  // namespace hazer::protocol
