#include "protocol/usb/open_dmx_frames.h"

#include <gtest/gtest.h>

#include "tests/protocol/allocation_counter.h"
#include "tests/protocol/packets.h"

namespace hazer::protocol {
namespace {

using test::Bytes;

constexpr std::uint8_t kIdle = 0x60;
constexpr std::uint8_t kBreak = 0x70;

/// What the frames look like that come out.
struct Line {
    OpenDmxFrames frames;
    std::vector<Bytes> shown;

    void receive(std::uint8_t lineStatus, const Bytes& payload) {
        const Bytes exact = test::prefixOf(payload, payload.size());
        if (const auto slots = frames.receive({0x01, lineStatus, exact})) {
            shown.emplace_back(slots->begin(), slots->end());
        }
    }

    /// Start code and slots in packets of at most `size`; the break that ends it comes with the last one, as
    /// a 0.
    void frame(const Bytes& bytes, std::size_t size, std::uint8_t afterBreak = kIdle) {
        Bytes rest = bytes;
        rest.push_back(0);
        std::uint8_t status = afterBreak;
        while (rest.size() > size) {
            receive(status, Bytes(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(size)));
            rest.erase(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(size));
            status = kIdle;
        }
        receive(kBreak, rest);
    }
};

Bytes frameOf(std::size_t slots, std::uint8_t value) {
    Bytes frame(1 + slots, value);
    frame[0] = 0;
    return frame;
}

TEST(OpenDmxFrames, ShowsFramesOfOneLengthFromTheSecondOn) {
    Line line;
    line.receive(kBreak, {1, 2, 0});
    line.frame(frameOf(100, 7), 62);
    EXPECT_TRUE(line.shown.empty()) << "could be a part of one";
    line.frame(frameOf(100, 8), 62);
    EXPECT_EQ(line.shown, std::vector<Bytes>{Bytes(100, 8)});
    EXPECT_EQ(line.frames.counters().doubtful, 1U);
}

TEST(OpenDmxFrames, AFullFrameIsShownBeforeTheNextBreak) {
    Line line;
    line.receive(kBreak, {0});
    line.frame(frameOf(512, 1), 62);
    Bytes second = frameOf(512, 2);
    line.receive(kIdle, test::prefixOf(second, 500));
    EXPECT_TRUE(line.shown.empty());
    line.receive(kIdle, Bytes(13, 2));
    EXPECT_EQ(line.shown, std::vector<Bytes>{Bytes(512, 2)});
    line.receive(kIdle, Bytes(62, 3));
    line.receive(kBreak, {0});
    EXPECT_EQ(line.shown.size(), 1U) << "what is beyond slot 512 is no frame";
}

TEST(OpenDmxFrames, WhateverThePacketsAreAndWhereverTheyAreCut) {
    for (std::size_t size = 1; size <= 62; ++size) {
        Line line;
        line.receive(kBreak, {0});
        for (std::uint8_t value = 1; value <= 3; ++value) line.frame(frameOf(70, value), size);
        EXPECT_EQ(line.shown, (std::vector{Bytes(70, 2), Bytes(70, 3)})) << "packets of " << size;
    }
}

TEST(OpenDmxFrames, ABreakMayComeWithoutItsCharacter) {
    Line line;
    for (std::uint8_t value = 1; value <= 3; ++value) {
        line.receive(kBreak, {});
        line.receive(kBreak, {});
        line.receive(kIdle, {});
        line.receive(kIdle, frameOf(24, value));
    }
    line.receive(kBreak, {});
    EXPECT_EQ(line.shown, (std::vector{Bytes(24, 2), Bytes(24, 3)}));
}

TEST(OpenDmxFrames, TheFlagMayStayUpForOnePacketMore) {
    for (const std::uint8_t value : Bytes{0, 9}) {
        Line line;
        line.receive(kBreak, {0});
        for (int i = 0; i < 3; ++i) line.frame(frameOf(200, value), 62, kBreak);
        EXPECT_EQ(line.shown, std::vector(2, Bytes(200, value))) << "slots at " << int{value};
    }
}

// The dark start of a frame must not be cut off, or the rest would be taken for slots from 1 on.
TEST(OpenDmxFrames, TheFlagThatStaysUpCutsNoDarkSlotsOff) {
    Line line;
    line.receive(kBreak, {0});
    Bytes frame = frameOf(300, 0);
    frame[150] = 255;
    for (int i = 0; i < 4; ++i) line.frame(frame, 62, kBreak);
    EXPECT_EQ(line.shown, std::vector(3, Bytes(frame.begin() + 1, frame.end())));
}

TEST(OpenDmxFrames, ShortFramesInOnePacketEachAreFramesAllTheSame) {
    Line line;
    line.receive(kBreak, {0});
    for (std::uint8_t value = 1; value <= 5; ++value) line.frame(frameOf(24, value), 62);
    EXPECT_EQ(line.shown, (std::vector{Bytes(24, 3), Bytes(24, 4), Bytes(24, 5)}));
}

TEST(OpenDmxFrames, AFlagWithoutAZeroIsNoBreak) {
    Line line;
    line.receive(kBreak, {0});
    for (int i = 0; i < 2; ++i) {
        line.receive(kIdle, frameOf(40, 6));
        line.receive(kBreak, Bytes(10, 6));
        line.receive(kBreak, {0});
    }
    EXPECT_EQ(line.shown, std::vector<Bytes>{Bytes(50, 6)});
}

TEST(OpenDmxFrames, OneFrameCutShortByNoiseIsNotShown) {
    Line line;
    line.receive(kBreak, {0});
    for (int i = 0; i < 2; ++i) line.frame(frameOf(512, 100), 62);
    line.receive(kIdle, Bytes(50, 0));
    line.receive(kBreak, {0});
    line.frame(frameOf(462, 100), 62);
    line.frame(frameOf(512, 100), 62);
    EXPECT_EQ(line.shown, std::vector(2, Bytes(512, 100)));
    EXPECT_EQ(line.frames.counters().doubtful, 3U);
}

TEST(OpenDmxFrames, ADeskMayAlternateBetweenLengths) {
    Line line;
    line.receive(kBreak, {0});
    for (int i = 0; i < 3; ++i) {
        line.frame(frameOf(100, 1), 62);
        line.frame(frameOf(512, 2), 62);
    }
    EXPECT_EQ(line.shown.size(), 4U);
}

TEST(OpenDmxFrames, OtherStartCodesAreCountedAndShowNothing) {
    Line line;
    line.receive(kBreak, {0});
    for (int i = 0; i < 3; ++i) line.frame({0xCC, 1, 24, 9, 9}, 62);
    EXPECT_TRUE(line.shown.empty());
    EXPECT_EQ(line.frames.counters().otherCodes, 2U) << "the first stands for the doubt about the second";
    EXPECT_TRUE(line.frames.hasHeardDmx());
}

TEST(OpenDmxFrames, LostBytesDropTheFrame) {
    Line line;
    line.receive(kBreak, {0});
    line.frame(frameOf(100, 1), 62);
    line.receive(kIdle | kFtdiOverrun, frameOf(50, 2));
    line.frame(Bytes(50, 2), 62);
    EXPECT_TRUE(line.shown.empty());
    EXPECT_EQ(line.frames.counters().broken, 1U);
    line.frame(frameOf(100, 3), 62);
    EXPECT_EQ(line.shown, std::vector<Bytes>{Bytes(100, 3)});
}

TEST(OpenDmxFrames, NothingIsShownBeforeTheFirstBreakOrAfterAGap) {
    Line line;
    for (int i = 0; i < 20; ++i) line.receive(kIdle, Bytes(62, 0));
    line.receive(kBreak, {0});
    EXPECT_FALSE(line.frames.hasHeardDmx());
    for (int i = 0; i < 2; ++i) line.frame(frameOf(100, 1), 62);
    line.receive(kIdle, frameOf(60, 1));
    line.frames.interrupt();
    line.receive(kIdle, Bytes(40, 1));
    line.receive(kBreak, {0});
    EXPECT_EQ(line.shown.size(), 1U);
    line.frame(frameOf(100, 2), 62);
    EXPECT_EQ(line.shown.back(), Bytes(100, 2));
}

TEST(OpenDmxFrames, AllocatesNothing) {
    OpenDmxFrames frames;
    const Bytes frame = frameOf(400, 1);
    const Bytes end{0};
    const std::size_t before = hazer::test::allocationCount();
    for (int i = 0; i < 3; ++i) {
        frames.receive({0x01, kIdle, frame});
        frames.receive({0x01, kBreak, end});
    }
    EXPECT_EQ(hazer::test::allocationCount(), before);
    EXPECT_EQ(frames.counters().frames, 1U);
}

TEST(FtdiPackets, HaveAStatusEach) {
    Bytes transfer(64 + 41, 5);
    transfer[0] = transfer[64] = 0x01;
    transfer[1] = 0x60;
    transfer[65] = 0x70;
    std::span<const std::uint8_t> rest(transfer);
    const auto first = takeFtdiPacket(rest, 64);
    const auto second = takeFtdiPacket(rest, 64);
    ASSERT_TRUE(first && second);
    EXPECT_EQ(first->payload.size(), 62U);
    EXPECT_EQ(first->lineStatus, 0x60);
    EXPECT_EQ(second->payload.size(), 39U);
    EXPECT_EQ(second->lineStatus, 0x70);
    EXPECT_FALSE(takeFtdiPacket(rest, 64));
}

TEST(FtdiPackets, AreThoseOfTheEndpointNotOfTheTransfer) {
    const Bytes transfer(512, 5);
    std::span<const std::uint8_t> slow(transfer);
    int packets = 0;
    while (takeFtdiPacket(slow, 64)) ++packets;
    EXPECT_EQ(packets, 8);
    std::span<const std::uint8_t> fast(transfer);
    EXPECT_EQ(takeFtdiPacket(fast, 512)->payload.size(), 510U);
}

TEST(FtdiPackets, HalfAStatusIsNone) {
    const Bytes half{0x01};
    std::span<const std::uint8_t> rest(half);
    EXPECT_FALSE(takeFtdiPacket(rest, 64));
    const Bytes bare{0x01, 0x60};
    rest = bare;
    EXPECT_TRUE(takeFtdiPacket(rest, 64)->payload.empty());
}

}  // namespace
}  // namespace hazer::protocol
