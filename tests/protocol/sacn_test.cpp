#include "protocol/sacn.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>

#include "tests/protocol/sacn_packets.h"

namespace hazer::protocol {
namespace {

using test::Bytes;
using test::prefixOf;
using test::sacnData;
using test::sacnDiscovery;
using test::sacnSync;
using ::testing::ElementsAre;

// Where the fields of E1.31 begin.
constexpr std::size_t kRootLength = 16;
constexpr std::size_t kRootVector = 18;
constexpr std::size_t kFramingLength = 38;
constexpr std::size_t kFramingVector = 40;
constexpr std::size_t kDmpLength = 115;
constexpr std::size_t kValueCount = 123;
constexpr std::size_t kListLength = 112;

SacnData dataOf(const Bytes& datagram) {
    const SacnPacket packet = parseSacn(datagram);
    const auto* data = std::get_if<SacnData>(&packet);
    EXPECT_TRUE(data) << "not parsed as data";
    return data ? *data : SacnData{};
}

SacnRefusal refusalOf(const Bytes& datagram) {
    const SacnPacket packet = parseSacn(datagram);
    const auto* refusal = std::get_if<SacnRefusal>(&packet);
    EXPECT_TRUE(refusal) << "taken, but should have been refused";
    return refusal ? *refusal : SacnRefusal{};
}

bool isTaken(const Bytes& datagram) {
    return !std::holds_alternative<SacnRefusal>(parseSacn(datagram));
}

Bytes with(Bytes datagram, std::size_t offset, const Bytes& bytes) {
    std::ranges::copy(bytes, datagram.begin() + static_cast<std::ptrdiff_t>(offset));
    return datagram;
}

Bytes withU16(Bytes datagram, std::size_t offset, std::size_t value) {
    return with(std::move(datagram), offset,
                {static_cast<std::uint8_t>(value >> 8), static_cast<std::uint8_t>(value & 0xFF)});
}

TEST(SacnData, HasItsFieldsWhereTheStandardPutsThem) {
    Bytes datagram = sacnData({.slots = Bytes(512, 7)});
    ASSERT_EQ(datagram.size(), 638U);
    datagram[22] = 0xC0;  // CID
    datagram[37] = 0x1D;
    datagram[44] = 'D';   // source name
    datagram[108] = 150;  // priority
    datagram = withU16(datagram, 109, 7000);
    datagram[111] = 200;  // sequence
    datagram = withU16(datagram, 113, 63999);
    datagram[126] = 255;  // slot 1
    datagram[637] = 9;    // slot 512

    const SacnData data = dataOf(datagram);
    EXPECT_EQ(data.cid.front(), 0xC0);
    EXPECT_EQ(data.cid.back(), 0x1D);
    EXPECT_EQ(data.sourceName, "Desk");
    EXPECT_EQ(data.priority, 150);
    EXPECT_EQ(data.syncAddress, 7000);
    EXPECT_EQ(data.sequence, 200);
    EXPECT_EQ(data.universe, 63999);
    EXPECT_EQ(data.startCode, 0);
    ASSERT_EQ(data.slots.size(), 512U);
    EXPECT_EQ(data.slots[0], 255);
    EXPECT_EQ(data.slots[511], 9);
}

TEST(SacnData, TellsItsOptionsApart) {
    const SacnData preview = dataOf(sacnData({.options = 0x80}));
    EXPECT_TRUE(preview.isPreview && !preview.isTerminated && !preview.forcesSync);
    const SacnData terminated = dataOf(sacnData({.options = 0x40}));
    EXPECT_TRUE(!terminated.isPreview && terminated.isTerminated && !terminated.forcesSync);
    const SacnData forcing = dataOf(sacnData({.options = 0x20}));
    EXPECT_TRUE(!forcing.isPreview && !forcing.isTerminated && forcing.forcesSync);
    const SacnData reserved = dataOf(sacnData({.options = 0x1F}));
    EXPECT_TRUE(!reserved.isPreview && !reserved.isTerminated && !reserved.forcesSync);
}

TEST(SacnData, TakesEveryNumberOfSlots) {
    for (std::size_t count = 0; count <= 512; ++count) {
        EXPECT_EQ(dataOf(sacnData({.slots = Bytes(count, 1)})).slots.size(), count);
    }
}

TEST(SacnData, TakesOlasTerminationWithoutSlots) {
    const Bytes datagram = sacnData({.options = 0x40, .slots = {}});
    ASSERT_EQ(datagram.size(), 126U);
    EXPECT_TRUE(dataOf(datagram).isTerminated);
}

TEST(SacnData, GivesNoMoreThan512Slots) {
    EXPECT_EQ(dataOf(sacnData({.slots = Bytes(600, 1)})).slots.size(), 512U);
}

TEST(SacnData, EndsANameThatHasNoTerminator) {
    EXPECT_EQ(dataOf(sacnData({.name = std::string(64, 'x')})).sourceName, std::string(63, 'x'));
    EXPECT_EQ(dataOf(sacnData({.name = ""})).sourceName, "");
}

TEST(SacnData, RefusesPrioritiesAbove200) {
    EXPECT_EQ(dataOf(sacnData({.priority = 0})).priority, 0);
    EXPECT_EQ(dataOf(sacnData({.priority = 200})).priority, 200);
    for (int priority = 201; priority <= 255; ++priority) {
        EXPECT_EQ(refusalOf(sacnData({.priority = static_cast<std::uint8_t>(priority)})),
                  SacnRefusal::kBadPriority);
    }
}

// sACNView #198: the field was reserved before 2016, and packets with anything in it were thrown away.
TEST(SacnData, TakesAnySynchronizationAddress) {
    for (const std::uint16_t address : std::initializer_list<std::uint16_t>{1, 7000, 63999, 64000, 65535}) {
        EXPECT_EQ(dataOf(sacnData({.syncAddress = address})).syncAddress, address);
    }
}

TEST(SacnData, TakesUniverses1To63999) {
    for (const std::uint16_t universe : std::initializer_list<std::uint16_t>{1, 255, 256, 63999}) {
        EXPECT_EQ(dataOf(sacnData({.universe = universe})).universe, universe);
    }
    for (const std::uint16_t universe : std::initializer_list<std::uint16_t>{0, 64000, 64214, 65535}) {
        EXPECT_EQ(refusalOf(sacnData({.universe = universe})), SacnRefusal::kBadField);
    }
}

TEST(SacnData, GivesEveryStartCode) {
    for (const std::uint8_t code : std::initializer_list<std::uint8_t>{0x00, 0x17, 0xCC, 0xDD, 0xFF}) {
        EXPECT_EQ(dataOf(sacnData({.startCode = code})).startCode, code);
    }
}

TEST(SacnData, RefusesACountThatDoesNotFit) {
    const Bytes slots(100, 1);
    EXPECT_EQ(refusalOf(sacnData({.slots = slots, .claimedCount = 0})), SacnRefusal::kBadLength);
    EXPECT_EQ(refusalOf(sacnData({.slots = slots, .claimedCount = 102})), SacnRefusal::kBadLength);
    EXPECT_EQ(refusalOf(sacnData({.slots = slots, .claimedCount = 65535})), SacnRefusal::kBadLength);
}

TEST(SacnData, BelievesACountBelowWhatFollows) {
    EXPECT_EQ(dataOf(sacnData({.slots = Bytes(100, 1), .claimedCount = 51})).slots.size(), 50U);
    EXPECT_EQ(dataOf(sacnData({.slots = Bytes(100, 1), .claimedCount = 1})).slots.size(), 0U);
}

TEST(SacnData, RefusesFieldsThatCanHaveOneValueOnly) {
    const Bytes good = sacnData({});
    for (const std::size_t offset : {117U, 118U, 119U, 120U, 121U, 122U}) {
        EXPECT_EQ(refusalOf(with(good, offset, {0x5A})), SacnRefusal::kBadField) << offset;
    }
    for (std::size_t offset = 0; offset < 16; ++offset) {
        EXPECT_EQ(refusalOf(with(good, offset, {0x5A})), SacnRefusal::kNotSacn) << offset;
    }
}

TEST(SacnData, LeavesOtherVectorsAlone) {
    const Bytes good = sacnData({});
    for (const std::uint8_t vector : std::initializer_list<std::uint8_t>{0, 1, 5, 255}) {
        EXPECT_EQ(refusalOf(with(good, kRootVector + 3, {vector})), SacnRefusal::kUnusedVector);
    }
    for (const std::uint8_t vector : std::initializer_list<std::uint8_t>{0, 1, 3, 4}) {
        EXPECT_EQ(refusalOf(with(good, kFramingVector + 3, {vector})), SacnRefusal::kUnusedVector);
    }
    EXPECT_EQ(refusalOf(with(good, kRootVector, {1})), SacnRefusal::kUnusedVector);
}

TEST(SacnData, IgnoresBytesBehindItsEnd) {
    Bytes datagram = sacnData({.slots = {5, 6}});
    datagram.resize(datagram.size() + 40, 0xEE);
    EXPECT_THAT(dataOf(datagram).slots, ElementsAre(5, 6));
}

// Every length in a packet, every value that it can claim.
TEST(SacnData, NeverBelievesALengthOverTheDatagram) {
    const Bytes good = sacnData({.slots = Bytes(20, 1)});
    for (const std::size_t offset : {kRootLength, kFramingLength, kDmpLength}) {
        const std::size_t truth = good.size() - offset;
        for (std::size_t length = 0; length <= 0xFFF; ++length) {
            const Bytes lied = withU16(good, offset, 0x7000 | length);
            EXPECT_EQ(isTaken(lied), length == truth) << "length " << length << " at " << offset;
        }
        for (std::size_t flags = 0; flags < 16; ++flags) {
            EXPECT_EQ(isTaken(withU16(good, offset, flags << 12 | truth)), flags == 7) << flags;
        }
    }
    for (std::size_t count = 0; count <= 0xFFFF; ++count) {
        EXPECT_EQ(isTaken(withU16(good, kValueCount, count)), count >= 1 && count <= 21) << count;
    }
}

TEST(SacnData, RefusesEveryTruncatedPrefix) {
    for (const std::size_t slots : {0U, 1U, 5U, 512U}) {
        const Bytes whole = sacnData({.slots = Bytes(slots, 1)});
        for (std::size_t size = 0; size < whole.size(); ++size) {
            EXPECT_EQ(refusalOf(prefixOf(whole, size)),
                      size < 16 ? SacnRefusal::kNotSacn : SacnRefusal::kTruncated)
                << size;
        }
    }
}

TEST(SacnSync, HasItsFieldsWhereTheStandardPutsThem) {
    Bytes datagram = sacnSync(0, 0);
    ASSERT_EQ(datagram.size(), 49U);
    datagram[22] = 0xC0;
    datagram[44] = 17;
    datagram = withU16(datagram, 45, 7962);
    const SacnPacket packet = parseSacn(datagram);
    const SacnSync& sync = std::get<SacnSync>(packet);
    EXPECT_EQ(sync.cid.front(), 0xC0);
    EXPECT_EQ(sync.sequence, 17);
    EXPECT_EQ(sync.syncAddress, 7962);
}

TEST(SacnSync, RefusesEveryTruncatedPrefixAndEveryLie) {
    const Bytes good = sacnSync(1, 0);
    for (std::size_t size = 0; size < good.size(); ++size) EXPECT_FALSE(isTaken(prefixOf(good, size)));
    for (const std::size_t offset : {kRootLength, kFramingLength}) {
        for (std::size_t length = 0; length <= 0xFFF; ++length) {
            EXPECT_EQ(isTaken(withU16(good, offset, 0x7000 | length)), length == good.size() - offset);
        }
    }
}

TEST(SacnDiscovery, HasItsFieldsWhereTheStandardPutsThem) {
    const Bytes datagram = sacnDiscovery({.name = "node", .page = 1, .lastPage = 2, .universes = {1, 63999}});
    ASSERT_EQ(datagram.size(), 124U);
    EXPECT_EQ(datagram[118], 1);
    EXPECT_EQ(datagram[119], 2);
    EXPECT_EQ(datagram[122], 0xF9);
    const SacnPacket packet = parseSacn(datagram);
    const SacnDiscovery& discovery = std::get<SacnDiscovery>(packet);
    EXPECT_EQ(discovery.sourceName, "node");
    EXPECT_EQ(discovery.page, 1);
    EXPECT_EQ(discovery.lastPage, 2);
    ASSERT_EQ(discovery.universeCount(), 2U);
    EXPECT_EQ(discovery.universe(0), 1);
    EXPECT_EQ(discovery.universe(1), 63999);
}

// ETCLabs/sACN #67: lists of fewer than 40 universes were refused as malformed.
TEST(SacnDiscovery, TakesEveryNumberOfUniverses) {
    for (std::size_t count = 0; count <= 512; ++count) {
        const SacnPacket packet =
            parseSacn(sacnDiscovery({.universes = std::vector<std::uint16_t>(count, 3)}));
        const auto* discovery = std::get_if<SacnDiscovery>(&packet);
        ASSERT_TRUE(discovery) << count;
        EXPECT_EQ(discovery->universeCount(), count);
    }
    EXPECT_EQ(refusalOf(sacnDiscovery({.universes = std::vector<std::uint16_t>(513, 3)})),
              SacnRefusal::kBadLength);
}

TEST(SacnDiscovery, RefusesEveryTruncatedPrefixAndEveryLie) {
    const Bytes good = sacnDiscovery({.universes = {1, 2, 3}});
    for (std::size_t size = 0; size < good.size(); ++size) EXPECT_FALSE(isTaken(prefixOf(good, size)));
    for (const std::size_t offset : {kRootLength, kFramingLength}) {
        for (std::size_t length = 0; length <= 0xFFF; ++length) {
            EXPECT_EQ(isTaken(withU16(good, offset, 0x7000 | length)), length == good.size() - offset);
        }
    }
    for (std::size_t length = 0; length <= 0xFFF; ++length) {
        const bool isWholeList = length >= 8 && length <= 14 && length % 2 == 0;
        EXPECT_EQ(isTaken(withU16(good, kListLength, 0x7000 | length)), isWholeList) << length;
    }
}

TEST(SacnDiscovery, RefusesAPageBehindTheLast) {
    EXPECT_EQ(refusalOf(sacnDiscovery({.page = 2, .lastPage = 1})), SacnRefusal::kBadField);
}

TEST(SacnDiscovery, LeavesOlasDraftAlone) {
    EXPECT_EQ(test::olaDraftDiscovery().size(), 121U);
    EXPECT_EQ(refusalOf(test::olaDraftDiscovery()), SacnRefusal::kUnusedVector);
}

TEST(PackSacn, WritesWhatTheHandWrittenPacketsHold) {
    const Bytes slots{9, 8, 7};
    SacnData data;
    data.cid.fill(3);
    data.sourceName = "desk";
    data.priority = 77;
    data.syncAddress = 500;
    data.sequence = 12;
    data.universe = 513;
    data.slots = slots;
    EXPECT_EQ(
        packSacnData(data),
        sacnData(
            {.cid = 3, .priority = 77, .syncAddress = 500, .sequence = 12, .universe = 513, .slots = slots}));
    data.isPreview = data.isTerminated = data.forcesSync = true;
    EXPECT_EQ(packSacnData(data)[112], 0xE0);
    data.startCode = kStartCodeSlotPriorities;
    EXPECT_EQ(packSacnData(data)[125], 0xDD);

    SacnSync sync;
    sync.cid.fill(3);
    sync.sequence = 200;
    sync.syncAddress = 7000;
    EXPECT_EQ(packSacnSync(sync), sacnSync(7000, 200, 3));

    SacnDiscovery discovery;
    discovery.cid.fill(3);
    discovery.sourceName = "desk";
    discovery.lastPage = 1;
    const Bytes universes{0, 1, 0xF9, 0xFF};
    discovery.universeBytes = universes;
    EXPECT_EQ(packSacnDiscovery(discovery),
              sacnDiscovery({.cid = 3, .lastPage = 1, .universes = {1, 63999}}));
}

TEST(PackSacn, CutsANameThatIsTooLong) {
    const std::string name(80, 'n');
    SacnData data;
    data.sourceName = name;
    const Bytes packed = packSacnData(data);
    EXPECT_EQ(packed[44 + 63], 0);
    EXPECT_EQ(dataOf(packed).sourceName, std::string(63, 'n'));
}

}  // namespace
}  // namespace hazer::protocol
