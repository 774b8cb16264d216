// The tables of an sACN listener, each alone: streams, synchronization, discovery.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocol/sacn_discovered.h"
#include "protocol/sacn_streams.h"
#include "protocol/sacn_sync.h"
#include "tests/protocol/sacn_packets.h"

namespace hazer::protocol {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr TimePoint kStart{std::chrono::hours(1)};
const IpEndpoint kDesk{.address = {10, 0, 0, 5}, .port = 5568};

Cid cidOf(std::uint32_t number) {
    Cid cid{};
    for (std::size_t i = 0; i < 4; ++i) cid[i] = static_cast<std::uint8_t>(number >> (8 * i));
    return cid;
}

/// A stream that has taken 100, and one packet after that.
bool takesAfter100(std::uint8_t sequence, TimePoint::duration later = 20ms) {
    SacnStreams streams;
    const SacnStreamKey key{1, false, cidOf(1)};
    streams.take(key, 100, "desk", kDesk, kStart);
    return streams.isInOrder(key, sequence, kStart + later);
}

TEST(SacnStreams, RefuseWhatIsLessThan20Behind) {
    EXPECT_TRUE(takesAfter100(101));
    EXPECT_TRUE(takesAfter100(100 + 127));
    EXPECT_FALSE(takesAfter100(100)) << "a duplicate";
    EXPECT_FALSE(takesAfter100(99));
    EXPECT_FALSE(takesAfter100(81));
    EXPECT_TRUE(takesAfter100(80)) << "a restart";
}

TEST(SacnStreams, CountThroughZero) {
    SacnStreams streams;
    const SacnStreamKey key{1, false, cidOf(1)};
    streams.take(key, 255, "desk", kDesk, kStart);
    EXPECT_TRUE(streams.isInOrder(key, 0, kStart));
    streams.take(key, 0, "desk", kDesk, kStart);
    EXPECT_FALSE(streams.isInOrder(key, 255, kStart)) << "as OLA, and unlike a plain difference of int";
    EXPECT_TRUE(streams.isInOrder(key, 200, kStart));
}

TEST(SacnStreams, BeginAnewAfterALoss) {
    EXPECT_FALSE(takesAfter100(90, 2500ms));
    EXPECT_TRUE(takesAfter100(90, 2501ms));
}

// k-yle/sACN #37: numbers kept for all senders together break with the second one.
TEST(SacnStreams, AreApartBySourceUniverseAndKindOfPacket) {
    SacnStreams streams;
    streams.take({1, false, cidOf(1)}, 100, "desk", kDesk, kStart);
    EXPECT_TRUE(streams.isInOrder({1, false, cidOf(2)}, 99, kStart));
    EXPECT_TRUE(streams.isInOrder({2, false, cidOf(1)}, 99, kStart));
    EXPECT_TRUE(streams.isInOrder({1, true, cidOf(1)}, 99, kStart));
}

TEST(SacnStreams, AskForADescriptionWhenThereIsNews) {
    SacnStreams streams;
    const SacnStreamKey key{1, false, cidOf(1)};
    EXPECT_TRUE(streams.take(key, 1, "desk", kDesk, kStart));
    EXPECT_FALSE(streams.take(key, 2, "desk", kDesk, kStart));
    EXPECT_TRUE(streams.take(key, 3, "front desk", kDesk, kStart));
    EXPECT_TRUE(streams.take(key, 4, "front desk", {.address = {10, 0, 0, 6}, .port = 5568}, kStart));
    EXPECT_TRUE(streams.take(key, 5, "front desk", {.address = {10, 0, 0, 6}, .port = 5568}, kStart + 3s));
}

TEST(SacnStreams, AreBoundedAndMakeRoomForTheLiving) {
    SacnStreams streams;
    for (std::uint32_t i = 0; i < SacnStreams::kCapacity + 1000; ++i) {
        streams.take({1, false, cidOf(i)}, 5, "flood", kDesk, kStart);
    }
    EXPECT_EQ(streams.size(), SacnStreams::kCapacity);
    const SacnStreamKey late{1, false, cidOf(1'000'000)};
    streams.take(late, 5, "desk", kDesk, kStart + 1s);
    EXPECT_TRUE(streams.isInOrder(late, 4, kStart + 1s)) << "not remembered: taken in any order";
    streams.take(late, 5, "desk", kDesk, kStart + 6s);
    EXPECT_FALSE(streams.isInOrder(late, 4, kStart + 6s));
    EXPECT_EQ(streams.size(), 1U);
}

TEST(SacnSyncTable, LevelsWaitOnceSynchronizationHasComeAndNotBefore) {
    SacnSyncTable table;
    EXPECT_FALSE(table.takeSync(7000, kStart)) << "nobody waits for it";
    EXPECT_FALSE(table.mustWait(7000, false, kStart));
    EXPECT_TRUE(table.takeSync(7000, kStart));
    EXPECT_TRUE(table.mustWait(7000, false, kStart + 10ms));
    EXPECT_FALSE(table.mustWait(7001, false, kStart + 10ms)) << "another address";
    EXPECT_FALSE(table.mustWait(0, false, kStart + 10ms));
    EXPECT_FALSE(table.mustWait(64000, false, kStart + 10ms)) << "out of range";
}

TEST(SacnSyncTable, AfterALossOnlyForcedLevelsGoOn) {
    SacnSyncTable table;
    table.mustWait(7000, false, kStart);
    table.takeSync(7000, kStart);
    EXPECT_TRUE(table.mustWait(7000, true, kStart + 2500ms)) << "not lost yet";
    EXPECT_FALSE(table.mustWait(7000, true, kStart + 2501ms));
    EXPECT_TRUE(table.mustWait(7000, false, kStart + 2501ms)) << "the last look is held";
    EXPECT_TRUE(table.mustWait(7000, false, kStart + 1h));
    EXPECT_TRUE(table.status(kStart + 1h).front().isLost);
    table.takeSync(7000, kStart + 2h);
    EXPECT_TRUE(table.mustWait(7000, true, kStart + 2h)) << "synchronization has resumed";
}

TEST(SacnSyncTable, IsBoundedAndSaysWhenItChanges) {
    SacnSyncTable table;
    for (std::uint16_t address = 1; address <= 1000; ++address) table.mustWait(address, false, kStart);
    EXPECT_EQ(table.status(kStart).size(), SacnSyncTable::kCapacity);
    EXPECT_EQ(table.revision(), SacnSyncTable::kCapacity);
    EXPECT_FALSE(table.takeSync(1000, kStart));
    table.mustWait(1000, false, kStart + 3s);
    EXPECT_TRUE(table.takeSync(1000, kStart + 3s)) << "took the place of one that nobody names any more";
    EXPECT_EQ(table.status(kStart).size(), SacnSyncTable::kCapacity);
    EXPECT_EQ(table.revision(), SacnSyncTable::kCapacity + 1);
}

/// A page as it comes from the parser; the bytes must outlive it.
struct Page {
    explicit Page(const test::SacnDiscoveryFields& fields) : bytes(test::sacnDiscovery(fields)) {}
    SacnDiscovery parsed() const { return std::get<SacnDiscovery>(parseSacn(bytes)); }
    test::Bytes bytes;
};

TEST(SacnDiscoveredSources, TellWhoSendsWhat) {
    SacnDiscoveredSources sources;
    const Page page({.name = "node\x1b[2J", .universes = {1, 2, 0, 63999, 64214}});
    EXPECT_TRUE(sources.take(page.parsed(), kDesk, kStart));
    const auto all = sources.status(kStart + 1s);
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].name, "node\xEF\xBF\xBD[2J");
    EXPECT_EQ(all[0].address, "10.0.0.5");
    EXPECT_THAT(all[0].universes, ElementsAre(1, 2, 63999));
    EXPECT_EQ(all[0].lastSeen, kStart);
}

TEST(SacnDiscoveredSources, TellTheUniversesOfAllOnceEach) {
    SacnDiscoveredSources sources;
    const auto take = [&](std::uint32_t source, std::vector<std::uint16_t> universes, TimePoint at) {
        const Page page({.universes = std::move(universes)});
        SacnDiscovery discovery = page.parsed();
        discovery.cid = cidOf(source);
        sources.take(discovery, kDesk, at);
    };
    EXPECT_THAT(sources.universes(kStart), IsEmpty());
    take(1, {3, 70}, kStart);
    take(2, {1, 3, 63999}, kStart + 1s);
    EXPECT_THAT(sources.universes(kStart + 1s), ElementsAre(1, 3, 70, 63999));
    EXPECT_THAT(sources.universes(kStart + 20500ms), ElementsAre(1, 3, 63999)) << "the first is forgotten";
}

TEST(SacnDiscoveredSources, ReplaceAListOnlyByAWholeOne) {
    SacnDiscoveredSources sources;
    const auto take = [&](std::uint8_t page, std::uint8_t last, std::vector<std::uint16_t> universes) {
        sources.take(Page({.page = page, .lastPage = last, .universes = std::move(universes)}).parsed(),
                     kDesk, kStart);
        return sources.status(kStart).front().universes;
    };
    EXPECT_THAT(take(0, 1, {1, 2}), IsEmpty());
    EXPECT_THAT(take(1, 1, {3}), ElementsAre(1, 2, 3));
    EXPECT_THAT(take(0, 2, {7}), ElementsAre(1, 2, 3));
    EXPECT_THAT(take(2, 2, {9}), ElementsAre(1, 2, 3)) << "page 1 was lost";
    EXPECT_THAT(take(0, 0, {}), IsEmpty()) << "sends nothing any more";
}

TEST(SacnDiscoveredSources, ForgetAfterTwoIntervals) {
    SacnDiscoveredSources sources;
    sources.take(Page({}).parsed(), kDesk, kStart);
    EXPECT_EQ(sources.status(kStart + 20s).size(), 1U);
    EXPECT_EQ(sources.status(kStart + 20001ms).size(), 0U);
}

TEST(SacnDiscoveredSources, AreBoundedAgainstSpoofedFloods) {
    SacnDiscoveredSources sources;
    const Page page({});
    std::size_t taken = 0;
    for (std::uint32_t i = 0; i < 10'000; ++i) {
        SacnDiscovery discovery = page.parsed();
        discovery.cid = cidOf(i);
        taken += sources.take(discovery, kDesk, kStart) ? 1 : 0;
    }
    EXPECT_EQ(taken, SacnDiscoveredSources::kCapacity);
    EXPECT_EQ(sources.status(kStart).size(), SacnDiscoveredSources::kCapacity);
    SacnDiscovery later = page.parsed();
    later.cid = cidOf(1'000'000);
    EXPECT_TRUE(sources.take(later, kDesk, kStart + 21s));
}

}  // namespace
}  // namespace hazer::protocol
