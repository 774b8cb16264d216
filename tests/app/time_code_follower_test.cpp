#include "app/time_code_follower.h"

#include <gtest/gtest.h>

#include <random>

namespace hazer::app {
namespace {

using namespace std::chrono_literals;
using protocol::TimeCodeType;
using protocol::TimePoint;
using Time = TimeCodeFollower::Time;

constexpr TimePoint kStart{1h};
constexpr protocol::Endpoint kDesk{{10, 0, 0, 5}, 6454};
constexpr protocol::Endpoint kOtherDesk{{10, 0, 0, 6}, 6454};

/// Frame `frame` of a day; drop frame leaves frames 0 and 1 of nine minutes in ten out.
protocol::ArtTimeCode codeOf(long frame, TimeCodeType type) {
    constexpr long kRates[] = {24, 25, 30, 30};
    const long rate = kRates[static_cast<std::size_t>(type)];
    if (type == TimeCodeType::kDropFrame2997) {
        constexpr long kInTenMinutes = 17982;
        constexpr long kInMinute = 1798;
        const long rest = frame % kInTenMinutes;
        frame += 18 * (frame / kInTenMinutes) + (rest > 1 ? 2 * ((rest - 2) / kInMinute) : 0);
    }
    protocol::ArtTimeCode code;
    code.type = type;
    code.frames = static_cast<std::uint8_t>(frame % rate);
    code.seconds = static_cast<std::uint8_t>(frame / rate % 60);
    code.minutes = static_cast<std::uint8_t>(frame / rate / 60 % 60);
    code.hours = static_cast<std::uint8_t>(frame / rate / 3600);
    return code;
}

Time lengthOf(TimeCodeType type) {
    constexpr double kFramesPerS[] = {24.0, 25.0, 30000.0 / 1001.0, 30.0};
    return Time(std::llround(1e9 / kFramesPerS[static_cast<std::size_t>(type)]));
}

/// A desk that sends 25 frames a second.
class Desk {
 public:
    explicit Desk(TimeCodeFollower& follower) : follower_(follower) {}

    void send(long frame, TimePoint at) { follower_.take({codeOf(frame, TimeCodeType::kEbu25), kDesk, at}); }

    /// Frames first..last, one every 40 ms from `at` on.
    void run(long first, long last, TimePoint at) {
        for (long frame = first; frame <= last; ++frame) send(frame, at + (frame - first) * 40ms);
    }

 private:
    TimeCodeFollower& follower_;
};

TEST(TimeCodeFollower, IsNowhereBeforeTheFirstCode) {
    TimeCodeFollower follower;
    EXPECT_FALSE(follower.position(kStart));
    EXPECT_FALSE(follower.isRunning());
}

TEST(TimeCodeFollower, RunsBetweenTheFramesOfEveryRate) {
    for (const TimeCodeType type : {TimeCodeType::kFilm24, TimeCodeType::kEbu25, TimeCodeType::kDropFrame2997,
                                    TimeCodeType::kSmpte30}) {
        TimeCodeFollower follower;
        const Time length = lengthOf(type);
        const long first = 1795;  // across the minute in which drop frame leaves two out
        for (long i = 0; i < 100; ++i) {
            follower.take({codeOf(first + i, type), kDesk, kStart + i * length});
            const Time half = *follower.position(kStart + i * length + length / 2);
            const Time expected = (first + i) * length + (i == 0 ? Time(0) : length / 2);
            EXPECT_NEAR(static_cast<double>((half - expected).count()), 0.0, 1e4)
                << static_cast<int>(type) << ", frame " << i;
        }
        EXPECT_TRUE(follower.isRunning());
    }
}

TEST(TimeCodeFollower, SmoothsWhatTheNetworkDelays) {
    TimeCodeFollower follower;
    std::mt19937 random(1);
    std::uniform_int_distribution<int> delayMs(0, 15);
    Time before{};
    for (long i = 0; i < 500; ++i) {
        const TimePoint sent = kStart + i * 40ms;
        follower.take({codeOf(i, TimeCodeType::kEbu25), kDesk, sent + delayMs(random) * 1ms});
        for (const Time into : {15ms, 25ms, 35ms}) {
            const Time position = *follower.position(sent + into);
            if (i > 25) {
                EXPECT_NEAR(static_cast<double>((position - before).count()),
                            1e7 + (into == 15ms ? 1e7 : 0.0), 2e6);
            }
            EXPECT_GE(position, before) << "back at frame " << i;
            before = position;
        }
    }
    EXPECT_NEAR(static_cast<double>((before - (499 * 40ms + 35ms)).count()), -7.5e6, 5e6);
}

TEST(TimeCodeFollower, StandsAtTheLastCodeWhenNoneComes) {
    TimeCodeFollower follower;
    Desk(follower).run(100, 150, kStart);
    const TimePoint last = kStart + 50 * 40ms;
    EXPECT_EQ(follower.position(last + 200ms), 150 * 40ms + 200ms) << "a few may be lost";
    EXPECT_TRUE(follower.isRunning());
    EXPECT_EQ(follower.position(last + 250ms), 150 * 40ms);
    EXPECT_EQ(follower.position(last + 1h), 150 * 40ms);
    EXPECT_FALSE(follower.isRunning());
}

TEST(TimeCodeFollower, StandsAtACodeThatIsRepeated) {
    TimeCodeFollower follower;
    Desk desk(follower);
    desk.run(0, 50, kStart);
    for (int i = 1; i < 50; ++i) {
        desk.send(50, kStart + (50 + i) * 40ms);
        const Time position = *follower.position(kStart + (50 + i) * 40ms);
        if (i >= 7) {
            EXPECT_EQ(position, 50 * 40ms) << i;
        }
    }
    desk.run(51, 60, kStart + 100 * 40ms);
    EXPECT_EQ(follower.position(kStart + 109 * 40ms + 20ms), 60 * 40ms + 20ms) << "goes on from there";
}

TEST(TimeCodeFollower, TakesACodeThatIsSentTwiceOnce) {
    TimeCodeFollower follower;
    Desk desk(follower);
    for (long frame = 0; frame < 50; ++frame) {
        desk.send(frame, kStart + frame * 40ms);
        desk.send(frame, kStart + frame * 40ms + 20ms);
    }
    EXPECT_EQ(follower.position(kStart + 49 * 40ms + 30ms), 49 * 40ms + 30ms);
}

TEST(TimeCodeFollower, JumpsWithTheCode) {
    for (const long target : {0L, 10000L}) {
        TimeCodeFollower follower;
        Desk desk(follower);
        desk.run(500, 550, kStart);
        const TimePoint jump = kStart + 51 * 40ms;
        desk.send(target, jump);
        EXPECT_EQ(follower.position(jump + 30ms), target * 40ms) << "waits whether it runs";
        desk.send(target + 1, jump + 40ms);
        EXPECT_EQ(follower.position(jump + 60ms), (target + 1) * 40ms + 20ms);
    }
}

// A desk that is asked for a place while it stands sends its code once, or again and again.
TEST(TimeCodeFollower, GoesToAPlaceAndStaysThere) {
    TimeCodeFollower follower;
    Desk desk(follower);
    desk.send(1000, kStart);
    EXPECT_EQ(follower.position(kStart + 100ms), 40s);
    EXPECT_EQ(follower.position(kStart + 10s), 40s);
    desk.send(2500, kStart + 11s);
    EXPECT_EQ(follower.position(kStart + 11s), 100s);
    EXPECT_EQ(follower.position(kStart + 20s), 100s);
}

TEST(TimeCodeFollower, FollowsBackwardsAndFastForward) {
    for (const long step : {-1L, 20L}) {
        TimeCodeFollower follower;
        Desk desk(follower);
        desk.run(4000, 4050, kStart);
        for (long i = 1; i <= 100; ++i) {
            const TimePoint now = kStart + (50 + i) * 40ms;
            desk.send(4050 + i * step, now);
            const Time off = *follower.position(now) - (4050 + i * step) * 40ms;
            EXPECT_LE(off, TimeCodeFollower::kJumpsBeyond) << i;
            EXPECT_GE(off, -TimeCodeFollower::kJumpsBeyond) << i;
        }
    }
}

TEST(TimeCodeFollower, OutlivesLostAndSwappedPackets) {
    TimeCodeFollower follower;
    Desk desk(follower);
    desk.run(0, 50, kStart);
    Time before = *follower.position(kStart + 50 * 40ms);
    for (const long frame : {51L, 53L, 52L, 54L, 58L, 59L, 60L}) {
        const TimePoint now = kStart + frame * 40ms;
        desk.send(frame, now + (frame == 52 ? 80ms : 0ms));
        if (frame == 52) continue;
        const Time position = *follower.position(now + (frame == 54 ? 1ms : 0ms));
        EXPECT_GE(position, before);
        EXPECT_NEAR(static_cast<double>((position - frame * 40ms).count()), 0.0, 2e7);
        before = position;
    }
    EXPECT_TRUE(follower.isRunning());
}

TEST(TimeCodeFollower, FollowsADeskWhoseClockIsOff) {
    TimeCodeFollower follower;
    for (long i = 0; i < 2000; ++i) {
        const TimePoint now = kStart + i * 40200us;  // half a percent slow
        follower.take({codeOf(i, TimeCodeType::kEbu25), kDesk, now});
        EXPECT_NEAR(static_cast<double>((*follower.position(now) - i * 40ms).count()), 0.0, 3e6) << i;
        EXPECT_TRUE(i == 0 || follower.isRunning()) << i;
    }
}

TEST(TimeCodeFollower, StaysWithOneDeskAsLongAsItRuns) {
    TimeCodeFollower follower;
    Desk desk(follower);
    desk.run(0, 50, kStart);
    follower.take({codeOf(90000, TimeCodeType::kEbu25), kOtherDesk, kStart + 50 * 40ms + 1ms});
    EXPECT_EQ(follower.position(kStart + 50 * 40ms + 10ms), 50 * 40ms + 10ms);
    follower.take({codeOf(90001, TimeCodeType::kEbu25), kOtherDesk, kStart + 50 * 40ms + 250ms});
    EXPECT_EQ(follower.position(kStart + 50 * 40ms + 260ms), 90001 * 40ms);
}

TEST(TimeCodeFollower, MidnightIsAJumpToTheStart) {
    TimeCodeFollower follower;
    Desk desk(follower);
    desk.run(24L * 3600 * 25 - 50, 24L * 3600 * 25 - 1, kStart);
    desk.run(0, 1, kStart + 50 * 40ms);
    EXPECT_EQ(follower.position(kStart + 51 * 40ms), 40ms);
}

}  // namespace
}  // namespace hazer::app
