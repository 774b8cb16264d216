// Recordings that stand in for a desk: where they are, and how they meet what others send.
#include "app/playback.h"

#include <gtest/gtest.h>

#include <thread>

#include "app/inputs.h"
#include "tests/support/datagram.h"
#include "tests/support/temporary_folder.h"

namespace hazer::app {
namespace {

using namespace std::chrono_literals;
using protocol::TimePoint;

constexpr TimePoint kStart{1h};
constexpr protocol::UniverseId kUniverse{protocol::Transport::kArtNet, 1};

class PlaybackTest : public ::testing::Test {
 protected:
    /// A level for each second: 10 at 0, 20 at 1, 30 at 2; slot 2 is always 5.
    ShowRecording recording() {
        ShowRecording recording;
        recording.file = folder_.write("night.show", "OLA Show\n1 10,5\n1000\n1 20,5\n1000\n1 30,5\n");
        recording.map = {.transport = protocol::Transport::kArtNet};
        return recording;
    }

    static int levelOf(Playback& playback) {
        protocol::UniverseSet universes;
        playback.mergeInto(universes, kStart);
        return universes[kUniverse].slots[0];
    }

    static protocol::ReceivedTimeCode code(int hours, int seconds, int frames, TimePoint at) {
        protocol::ReceivedTimeCode received;
        received.code.hours = static_cast<std::uint8_t>(hours);
        received.code.seconds = static_cast<std::uint8_t>(seconds);
        received.code.frames = static_cast<std::uint8_t>(frames);
        received.time = at;
        return received;
    }

    hazer::test::TemporaryFolder folder_;
};

TEST_F(PlaybackTest, IsWhereTheTimeCodeSays) {
    ShowRecording night = recording();
    night.clock = PlaybackClock::kTimeCode;
    night.timeCodeStart = 10h;
    Playback playback(night, {}, false);
    EXPECT_TRUE(playback.followsTimeCode);
    playback.follow(std::nullopt, kStart);
    EXPECT_EQ(playback.time(), 0s);
    playback.follow(code(9, 59, 0, kStart), kStart);
    EXPECT_EQ(playback.time(), 0s) << "the recording has not begun";
    playback.follow(code(10, 2, 0, kStart + 1s), kStart + 1s);
    EXPECT_EQ(playback.time(), 2s);
    EXPECT_EQ(levelOf(playback), 30);
    playback.follow(code(10, 1, 0, kStart + 2s), kStart + 2s);
    EXPECT_EQ(levelOf(playback), 20) << "a jump back";
    playback.follow(code(10, 1, 1, kStart + 2040ms), kStart + 2050ms);
    EXPECT_EQ(playback.time(), 1050ms) << "runs between the codes";
    EXPECT_TRUE(playback.isCodeRunning());
    playback.follow(code(10, 1, 1, kStart + 2040ms), kStart + 9s);
    EXPECT_EQ(playback.time(), 1040ms) << "stands with the code";
}

// From the wire: what a receiver has heard leads the recording.
TEST_F(PlaybackTest, FollowsWhatArrivesOverLoopback) {
    Inputs inputs(parseShow("[[input]]\naddress='127.0.0.1'", "a.toml"));
    inputs.listen({.ports = {.artNet = 0}});
    const auto packet = protocol::packArtTimeCode({.seconds = 2, .type = protocol::TimeCodeType::kSmpte30});
    test::sendDatagram(inputs.port(), {reinterpret_cast<const char*>(packet.data()), packet.size()});
    for (int i = 0; i < 10000 && !inputs.artNet().timeCode; ++i) {
        std::this_thread::sleep_for(1ms);
    }
    Playback playback(recording(), {}, false);
    playback.follow(inputs.artNet().timeCode, protocol::Clock::now());
    EXPECT_EQ(playback.time(), 2s);
    EXPECT_EQ(levelOf(playback), 30);
}

TEST_F(PlaybackTest, AFarJumpIsPlayedBitByBitWhereThereIsNoIndex) {
    Playback playback(recording(), {}, false);
    for (int i = 1; i <= 3; ++i) {
        playback.follow(code(1, 0, 0, kStart), kStart + i * 20ms);
        EXPECT_EQ(playback.time(), i * 5s);
    }
}

protocol::UniverseSet deskWith(std::uint8_t first, std::uint8_t second) {
    protocol::UniverseSet universes;
    universes[kUniverse].slots[0] = first;
    universes[kUniverse].slots[1] = second;
    return universes;
}

TEST_F(PlaybackTest, TheHighestLevelOfFileAndDeskCounts) {
    Playback playback(recording(), {}, false);
    protocol::UniverseSet universes = deskWith(3, 7);
    playback.mergeInto(universes, kStart);
    EXPECT_EQ(universes[kUniverse].slots[0], 10);
    EXPECT_EQ(universes[kUniverse].slots[1], 7);
}

TEST_F(PlaybackTest, WithLtpWhoeverChangedLastHasAllSlots) {
    ShowRecording night = recording();
    night.merging.mode = protocol::MergeMode::kLatest;
    Playback playback(night, {}, false);
    const auto mergedWith = [&](std::uint8_t first, std::uint8_t second) {
        protocol::UniverseSet universes = deskWith(first, second);
        playback.mergeInto(universes, kStart);
        return std::pair<int, int>(universes[kUniverse].slots[0], universes[kUniverse].slots[1]);
    };
    EXPECT_EQ(mergedWith(90, 0), std::pair(10, 5)) << "the file began last";
    EXPECT_EQ(mergedWith(90, 0), std::pair(10, 5)) << "repeating a look is no change";
    EXPECT_EQ(mergedWith(0, 1), std::pair(0, 1));
    EXPECT_EQ(mergedWith(0, 1), std::pair(0, 1));
    playback.goTo(1s);
    EXPECT_EQ(mergedWith(0, 1), std::pair(20, 5));
}

TEST_F(PlaybackTest, WithLtpALostDeskGivesWay) {
    ShowRecording night = recording();
    night.merging.mode = protocol::MergeMode::kLatest;
    Playback playback(night, {}, false);
    protocol::UniverseSet universes = deskWith(1, 1);
    playback.mergeInto(universes, kStart);
    universes = deskWith(2, 2);
    universes[kUniverse].isLost = true;
    playback.mergeInto(universes, kStart);
    EXPECT_EQ(universes[kUniverse].slots[0], 10);
    EXPECT_FALSE(universes[kUniverse].isLost);
}

}  // namespace
}  // namespace hazer::app
