#include "protocol/recording/recording_player.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/protocol/recording/capture_builder.h"
#include "tests/protocol/recording/evening.h"
#include "tests/support/temporary_folder.h"

namespace hazer::protocol::test {
namespace {

using namespace std::chrono_literals;

std::string describe(const Universe& universe) {
    std::string text =
        fmt::format("{} slots, {} packets, at {}, lost {}:", universe.slotCount, universe.packetCount,
                    universe.lastReceived.time_since_epoch().count(), universe.isLost);
    for (std::size_t i = 0; i < 24; ++i) text += fmt::format(" {}", universe.slots[i]);
    return text;
}

std::string describe(const SourceStatus& source) {
    return fmt::format("  {} '{}' '{}' priority {} {}{}{}{}{} rate {} packets {} late {} losses {} at {}\n",
                       fmt::join(source.id.id, "."), source.name, source.address, source.priority,
                       source.hasSlotPriorities ? "slots " : "", source.isAlive ? "alive " : "",
                       source.isWinning ? "wins " : "", source.isPreview ? "preview " : "",
                       source.isSynchronized ? "synchronized" : "", source.packetsPerS, source.packetCount,
                       source.lateCount, source.lossCount, source.lastReceived.time_since_epoch().count());
}

/// Everything that can be asked about the state, as text: two states are the same if these are.
std::string describe(RecordingPlayer& player) {
    std::string text =
        fmt::format("{} packets, {} refused\n", player.state().packetCount(), player.refusedCount());
    UniverseSet looks;
    player.latch(looks);
    for (const auto& [id, universe] : looks) {
        text += fmt::format("look {}/{} {}\n", static_cast<int>(id.transport), id.number, describe(universe));
    }
    for (const UniverseStatus& status : player.status()) {
        text +=
            fmt::format("universe {}/{} lost {} merging {} packets {} refused {} {}\n",
                        static_cast<int>(status.universe.transport), status.universe.number, status.isLost,
                        status.isMerging, status.packetCount, status.refusedSources, describe(status.look));
        for (const SourceStatus& source : status.sources) text += describe(source);
    }
    const ReceiverCounters& artNet = player.state().artNet().counters();
    const SacnCounters& sacn = player.state().sacn().counters();
    text += fmt::format("Art-Net {} {} {} {} {} {}\n", artNet.dmx, artNet.late, artNet.refused, artNet.polls,
                        artNet.ignored, artNet.malformed);
    text +=
        fmt::format("sACN {} {} {} {} {} {} {} {} {}\n", sacn.levels, sacn.slotPriorities, sacn.terminations,
                    sacn.syncs, sacn.discoveries, sacn.late, sacn.tooMany, sacn.ignored, sacn.malformed);
    return text;
}

class RecordingPlayerTest : public ::testing::Test {
 protected:
    std::unique_ptr<RecordingPlayer> player(RecordingPlayer::Indexing indexing,
                                            const ReplayRules& rules = {}) {
        auto made = std::make_unique<RecordingPlayer>(file_, FrameMap{}, rules, indexing);
        made->awaitIndex();
        return made;
    }

    hazer::test::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_.path() / "evening.pcap";
};

TEST_F(RecordingPlayerTest, SeekingGivesWhatPlayingGives) {
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
        writeCapture(file_, makeEvening(seed, 30000));
        ReplayRules rules;
        rules.merge.loss = {.fadesOut = true};
        rules.asked = {{Transport::kArtNet, 1}, {Transport::kAny, 2}};
        const auto seeking = player(RecordingPlayer::Indexing::kBackground, rules);
        ASSERT_GE(seeking->index().size(), 7u);
        ASSERT_TRUE(seeking->duration());
        std::mt19937_64 random(seed);
        std::uniform_int_distribution<std::int64_t> anyTime(0, seeking->duration()->count() + 5'000'000'000);
        std::vector<RecordingTime> times;
        for (int i = 0; i < 40; ++i) times.emplace_back(anyTime(random));
        std::map<RecordingTime, std::string> sought;
        for (const RecordingTime time : times) {
            seeking->goTo(time);
            sought[time] = describe(*seeking);
        }
        const auto playing = player(RecordingPlayer::Indexing::kNone, rules);
        for (const auto& [time, state] : sought) {
            playing->goTo(time);
            ASSERT_EQ(describe(*playing), state) << "seed " << seed << " at " << time.count() << " ns";
        }
    }
}

// A state may not depend on how often somebody looked at it on the way.
TEST_F(RecordingPlayerTest, LookingChangesNothing) {
    writeCapture(file_, makeEvening(4, 5000));
    const auto watched = player(RecordingPlayer::Indexing::kNone);
    const auto alone = player(RecordingPlayer::Indexing::kNone);
    for (RecordingTime time{}; time < 60s; time += 7ms) {
        watched->goTo(time);
        describe(*watched);
    }
    alone->goTo(watched->time());
    EXPECT_EQ(describe(*alone), describe(*watched));
}

TEST_F(RecordingPlayerTest, GoesToAMomentWithItsPackets) {
    writeCapture(file_, {{0ns, {{10, 0, 0, 1}, false, 6454}, {{}, false, 6454}, dmxDatagram({.slots = {1}})},
                         {1s, {{10, 0, 0, 1}, false, 6454}, {{}, false, 6454}, dmxDatagram({.slots = {2}})},
                         {1s, {{10, 0, 0, 1}, false, 6454}, {{}, false, 6454}, dmxDatagram({.slots = {3}})},
                         {2s, {{10, 0, 0, 1}, false, 6454}, {{}, false, 6454}, dmxDatagram({.slots = {4}})}});
    const auto played = player(RecordingPlayer::Indexing::kNone);
    const auto slotAt = [&](RecordingTime time) {
        played->goTo(time);
        UniverseSet looks;
        played->latch(looks);
        return int{looks.at({Transport::kArtNet, 0}).slots[0]};
    };
    EXPECT_EQ(slotAt(0ns), 1);
    EXPECT_EQ(slotAt(1s - 1ns), 1);
    EXPECT_EQ(slotAt(1s), 3);
    EXPECT_EQ(slotAt(500ms), 1);
    EXPECT_EQ(slotAt(1h), 4);
    EXPECT_EQ(slotAt(2s - 1ns), 3);
    played->goToEnd();
    EXPECT_EQ(played->time(), 2s);
    EXPECT_EQ(played->state().packetCount(), 4u);
}

TEST_F(RecordingPlayerTest, IndexStaysBoundedAndWhole) {
    ReplayIndex index;
    const auto state = std::make_shared<ReplayState>();
    RecordedPacket packet{{}, RecordedDatagram{}};
    for (std::int64_t i = 1; i <= 300'000; ++i) {
        packet.time = std::chrono::microseconds(i);
        state->play(packet);
        if (index.wants(state->packetCount())) {
            index.add({packet.time, nullptr, std::make_shared<ReplayState>(*state)});
        }
        ASSERT_LE(index.size(), ReplayIndex::kMostKeyFrames);
    }
    EXPECT_EQ(index.size(), 300'000 / ReplayIndex::kFirstDistance);
    const auto frame = index.before(200ms);
    ASSERT_TRUE(frame);
    EXPECT_LE(frame->time, 200ms);
    EXPECT_GT(frame->time, 200ms - std::chrono::microseconds(ReplayIndex::kFirstDistance));
    EXPECT_FALSE(index.before(1us));
}

TEST_F(RecordingPlayerTest, IndexHalvesWhenItIsFull) {
    constexpr std::size_t kMost = 64;
    ReplayIndex index(kMost);
    std::uint64_t packets = 0;
    const auto state = std::make_shared<ReplayState>();
    RecordedPacket packet{{}, RecordedDatagram{}};
    while (packets < (kMost + 1) * ReplayIndex::kFirstDistance) {
        packet.time = std::chrono::microseconds(++packets);
        state->play(packet);
        if (index.wants(packets)) index.add({packet.time, nullptr, std::make_shared<ReplayState>(*state)});
    }
    EXPECT_EQ(index.size(), kMost / 2);
    EXPECT_FALSE(index.wants(packets + 2 * ReplayIndex::kFirstDistance));
}

}  // namespace
}  // namespace hazer::protocol::test
