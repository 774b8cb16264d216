#include "protocol/sacn_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/protocol/packets.h"

namespace hazer::protocol {
namespace {

using namespace std::chrono_literals;
using test::Bytes;
using ::testing::ElementsAre;

constexpr TimePoint kStart{std::chrono::hours(1)};

/// Something that was sent, with the datagram that its spans refer into.
struct Sent {
    std::uint16_t number = 0;
    TimePoint time{};
    Bytes bytes;

    SacnPacket packet() const { return parseSacn(bytes); }
    SacnData data() const { return std::get<SacnData>(packet()); }
    bool isData() const { return std::holds_alternative<SacnData>(packet()); }
    bool isSync() const { return std::holds_alternative<SacnSync>(packet()); }
    bool isDiscovery() const { return std::holds_alternative<SacnDiscovery>(packet()); }
};

class Wire {
 public:
    explicit Wire(SacnSourceConfig config = {}) : source(named(std::move(config))) {}

    /// Lets the source send whenever something is due, up to and including `now + time`.
    void run(TimePoint::duration time) {
        const TimePoint end = now + time;
        for (auto due = source.nextDue(); due && *due <= end; due = source.nextDue()) {
            now = std::max(now, *due);
            source.emitDue(now, emit());
        }
        now = end;
    }

    SacnSource::Emit emit() {
        return [this](std::uint16_t number, std::span<const std::uint8_t> datagram) {
            sent.push_back({number, now, Bytes(datagram.begin(), datagram.end())});
        };
    }

    /// When data of that universe and start code was sent, in ms after kStart.
    std::vector<double> times(std::uint16_t universe, std::uint8_t startCode = 0) const {
        std::vector<double> all;
        for (const Sent& one : sent) {
            if (!one.isData() || one.data().universe != universe || one.data().startCode != startCode)
                continue;
            all.push_back(std::chrono::duration<double, std::milli>(one.time - kStart).count());
        }
        return all;
    }

    TimePoint now = kStart;
    std::vector<Sent> sent;
    SacnSource source;

 private:
    static SacnSourceConfig named(SacnSourceConfig config) {
        config.cid.fill(7);
        return config;
    }
};

TEST(SacnSource, SaysNothingBeforeItHasLevels) {
    Wire wire;
    EXPECT_FALSE(wire.source.nextDue());
    wire.source.emitDue(kStart, wire.emit());
    EXPECT_TRUE(wire.sent.empty());
}

TEST(SacnSource, RepeatsAChangeThreeTimesThenKeepsAlive) {
    Wire wire;
    wire.source.setLevels(1, Bytes{1, 2, 3});
    wire.run(3s);
    const std::vector<double> times = wire.times(1);
    ASSERT_GE(times.size(), 6U);
    EXPECT_EQ(times[0], 0.0);
    for (std::size_t i = 1; i <= 3; ++i) EXPECT_NEAR(times[i] - times[i - 1], 22.7, 0.01);
    for (std::size_t i = 4; i < times.size(); ++i) {
        EXPECT_GE(times[i] - times[i - 1], 800.0);
        EXPECT_LE(times[i] - times[i - 1], 1000.0);
    }
    EXPECT_EQ(times.size(), 4U + 3U);
}

TEST(SacnSource, SendsAChangeAtOnce) {
    Wire wire;
    wire.source.setLevels(1, Bytes{1});
    wire.run(1s);
    const std::size_t before = wire.times(1).size();
    wire.source.setLevels(1, Bytes{1});
    EXPECT_GT(*wire.source.nextDue(), wire.now) << "unchanged";
    wire.source.setLevels(1, Bytes{2});
    EXPECT_LE(*wire.source.nextDue(), wire.now);
    wire.run(100ms);
    EXPECT_EQ(wire.times(1).size(), before + 4);
    EXPECT_THAT(wire.sent.back().data().slots, ElementsAre(2));
}

TEST(SacnSource, CountsEachUniverseForItself) {
    Wire wire;
    for (int i = 0; i < 300; ++i) {
        wire.source.setLevels(1, Bytes{static_cast<std::uint8_t>(i & 1)});
        wire.source.emitDue(wire.now, wire.emit());
    }
    wire.source.setLevels(2, Bytes{1});
    wire.source.emitDue(wire.now, wire.emit());
    std::uint8_t expected = 0;
    for (const Sent& one : wire.sent) {
        if (!one.isData() || one.data().universe != 1) continue;
        EXPECT_EQ(one.data().sequence, expected++);
    }
    EXPECT_EQ(wire.sent.back().data().universe, 2);
    EXPECT_EQ(wire.sent.back().data().sequence, 0);
}

TEST(SacnSource, SharesTheSequenceBetweenStartCodes) {
    Wire wire;
    wire.source.setSlotPriorities(1, Bytes{100, 0});
    wire.source.setLevels(1, Bytes{1, 2});
    wire.run(10s);
    EXPECT_EQ(wire.sent[0].data().startCode, 0xDD) << "priorities before the levels that they rule";
    EXPECT_EQ(wire.sent[1].data().startCode, 0x00);
    std::uint8_t expected = 0;
    for (const Sent& one : wire.sent) {
        if (!one.isData()) continue;
        EXPECT_EQ(one.data().sequence, expected++);
    }
    EXPECT_GE(wire.times(1, 0xDD).size(), 10U) << "kept alive, too";
}

TEST(SacnSource, SaysWhatItIsConfiguredTo) {
    Wire wire({.name = "Pult", .priority = 150, .isPreview = true});
    wire.source.setLevels(63999, Bytes(512, 9));
    wire.run(0s);
    const SacnData data = wire.sent[0].data();
    EXPECT_EQ(wire.sent[0].number, 63999);
    EXPECT_EQ(data.cid.front(), 7);
    EXPECT_EQ(data.sourceName, "Pult");
    EXPECT_EQ(data.priority, 150);
    EXPECT_EQ(data.syncAddress, 0);
    EXPECT_TRUE(data.isPreview);
    EXPECT_EQ(data.slots.size(), 512U);
}

TEST(SacnSource, FollowsEveryFrameWithOneSynchronization) {
    Wire wire({.syncAddress = 7000});
    wire.source.setLevels(1, Bytes{1});
    wire.source.setLevels(2, Bytes{1});
    wire.run(0s);
    ASSERT_EQ(wire.sent.size(), 4U);
    EXPECT_EQ(wire.sent[0].data().syncAddress, 7000);
    EXPECT_EQ(wire.sent[1].data().syncAddress, 7000);
    ASSERT_TRUE(wire.sent[2].isSync());
    EXPECT_EQ(wire.sent[2].number, 7000);
    EXPECT_TRUE(wire.sent[3].isDiscovery());
    wire.run(9s);
    const auto levels = std::ranges::count_if(wire.sent, &Sent::isData);
    const auto syncs = std::ranges::count_if(wire.sent, &Sent::isSync);
    EXPECT_EQ(levels, 2 * syncs);
    EXPECT_GE(syncs, 12) << "often enough that no receiver takes synchronization for lost";
}

TEST(SacnSource, AnnouncesItsUniversesEveryTenSeconds) {
    Wire wire;
    wire.source.setLevels(5, Bytes{1});
    wire.source.setLevels(3, Bytes{1});
    wire.run(25s);
    std::vector<TimePoint> times;
    for (const Sent& one : wire.sent) {
        if (!one.isDiscovery()) continue;
        times.push_back(one.time);
        const SacnPacket packet = one.packet();
        const SacnDiscovery& list = std::get<SacnDiscovery>(packet);
        EXPECT_EQ(one.number, 64214);
        ASSERT_EQ(list.universeCount(), 2U);
        EXPECT_EQ(list.universe(0), 3);
        EXPECT_EQ(list.universe(1), 5);
    }
    EXPECT_THAT(times, ElementsAre(kStart, kStart + 10s, kStart + 20s));
}

TEST(SacnSource, AnnouncesManyUniversesPageByPage) {
    Wire wire;
    for (std::uint16_t universe = 1; universe <= 1025; ++universe) wire.source.setLevels(universe, Bytes{1});
    wire.run(0s);
    std::vector<int> counts;
    for (const Sent& one : wire.sent) {
        if (!one.isDiscovery()) continue;
        const SacnPacket packet = one.packet();
        const SacnDiscovery& list = std::get<SacnDiscovery>(packet);
        EXPECT_EQ(list.page, counts.size());
        EXPECT_EQ(list.lastPage, 2);
        counts.push_back(static_cast<int>(list.universeCount()));
    }
    EXPECT_THAT(counts, ElementsAre(512, 512, 1));
}

TEST(SacnSource, EndsEveryUniverseThreeTimes) {
    Wire wire;
    wire.source.setLevels(1, Bytes{1});
    wire.source.setLevels(2, Bytes{1});
    wire.run(0s);
    const std::size_t before = wire.sent.size();
    wire.source.terminate(wire.emit());
    ASSERT_EQ(wire.sent.size(), before + 6);
    for (std::size_t i = 0; i < 6; ++i) {
        const SacnData data = wire.sent[before + i].data();
        EXPECT_TRUE(data.isTerminated);
        EXPECT_EQ(data.universe, 1 + i % 2);
        EXPECT_EQ(data.sequence, 1 + i / 2) << "numbered on";
    }
    EXPECT_FALSE(wire.source.nextDue());
}

TEST(RandomCid, IsAnotherOneEachTimeAndAUuidOfVersion4) {
    std::set<Cid> all;
    for (int i = 0; i < 100; ++i) {
        const Cid cid = randomCid();
        EXPECT_EQ(cid[6] & 0xF0, 0x40);
        EXPECT_EQ(cid[8] & 0xC0, 0x80);
        all.insert(cid);
    }
    EXPECT_EQ(all.size(), 100U);
}

}  // namespace
}  // namespace hazer::protocol
