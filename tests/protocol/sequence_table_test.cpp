#include "protocol/sequence_table.h"

#include <gtest/gtest.h>

namespace hazer::protocol {
namespace {

using std::chrono::milliseconds;

const StreamKey kDesk{.source = {{10, 0, 0, 1}, 6454}, .portAddress = 3};
const TimePoint kStart{std::chrono::hours(1)};

StreamKey numberedDesk(std::size_t number) {
    StreamKey key = kDesk;
    key.source.address[2] = static_cast<std::uint8_t>(number >> 8);
    key.source.address[3] = static_cast<std::uint8_t>(number & 0xFF);
    return key;
}

// Whether `next` is taken 10 ms after `first`.
bool acceptsAfter(std::uint8_t first, std::uint8_t next) {
    SequenceTable table;
    EXPECT_TRUE(table.accept(kDesk, first, kStart));
    return table.accept(kDesk, next, kStart + milliseconds(10));
}

TEST(SequenceTable, TakesWhatFollows) {
    EXPECT_TRUE(acceptsAfter(1, 2));
    EXPECT_TRUE(acceptsAfter(1, 100));  // packets between were lost
    EXPECT_TRUE(acceptsAfter(255, 1));  // wraps as the standard says
}

TEST(SequenceTable, RefusesDuplicatesAndThePast) {
    EXPECT_FALSE(acceptsAfter(7, 7));
    EXPECT_FALSE(acceptsAfter(7, 6));
    EXPECT_FALSE(acceptsAfter(1, 255));  // late across the wrap
    EXPECT_FALSE(acceptsAfter(100, 81));
}

TEST(SequenceTable, TakesAJumpFarBackForARestart) {
    EXPECT_TRUE(acceptsAfter(100, 80));
    EXPECT_TRUE(acceptsAfter(100, 1));
}

TEST(SequenceTable, ALatePacketDoesNotMoveTheOrder) {
    SequenceTable table;
    EXPECT_TRUE(table.accept(kDesk, 10, kStart));
    EXPECT_FALSE(table.accept(kDesk, 9, kStart));
    EXPECT_FALSE(table.accept(kDesk, 10, kStart));
    EXPECT_TRUE(table.accept(kDesk, 11, kStart));
}

TEST(SequenceTable, ZeroHasNoOrderAndDoesNotResetIt) {
    SequenceTable table;
    EXPECT_TRUE(table.accept(kDesk, 254, kStart));
    EXPECT_TRUE(table.accept(kDesk, 255, kStart));
    EXPECT_TRUE(table.accept(kDesk, 0, kStart));  // some senders count through 0
    EXPECT_TRUE(table.accept(kDesk, 0, kStart));
    EXPECT_FALSE(table.accept(kDesk, 255, kStart));
    EXPECT_TRUE(table.accept(kDesk, 1, kStart));
}

TEST(SequenceTable, ForgetsAStreamAfterOneSecond) {
    SequenceTable table;
    EXPECT_TRUE(table.accept(kDesk, 5, kStart));
    EXPECT_FALSE(table.accept(kDesk, 1, kStart + milliseconds(1000)));
    EXPECT_TRUE(table.accept(kDesk, 1, kStart + milliseconds(1001)));
    EXPECT_TRUE(table.accept(kDesk, 2, kStart + milliseconds(1002)));
}

TEST(SequenceTable, StreamsDoNotDisturbOneAnother) {
    SequenceTable table;
    EXPECT_TRUE(table.accept(kDesk, 9, kStart));
    StreamKey otherAddress = kDesk, otherPort = kDesk, otherInput = kDesk, otherUniverse = kDesk;
    otherAddress.source.address[3] = 2;
    otherPort.source.port = 50000;
    otherInput.physical = 1;
    otherUniverse.portAddress = 4;
    for (const StreamKey& key : {otherAddress, otherPort, otherInput, otherUniverse}) {
        EXPECT_TRUE(table.accept(key, 5, kStart));
    }
    EXPECT_FALSE(table.accept(kDesk, 8, kStart));
}

TEST(SequenceTable, FullOfYoungStreamsItTakesFurtherOnesWithoutOrder) {
    SequenceTable table;
    for (std::size_t i = 0; i < SequenceTable::kCapacity; ++i) table.accept(numberedDesk(i), 5, kStart);
    const StreamKey oneTooMany = numberedDesk(SequenceTable::kCapacity);
    EXPECT_TRUE(table.accept(oneTooMany, 5, kStart));
    EXPECT_TRUE(table.accept(oneTooMany, 5, kStart));
    EXPECT_FALSE(table.accept(numberedDesk(0), 5, kStart));  // those inside keep theirs
}

TEST(SequenceTable, FullOfOldStreamsItMakesRoom) {
    SequenceTable table;
    for (std::size_t i = 0; i < SequenceTable::kCapacity; ++i) table.accept(numberedDesk(i), 5, kStart);
    const StreamKey late = numberedDesk(SequenceTable::kCapacity);
    const TimePoint later = kStart + milliseconds(1500);
    EXPECT_TRUE(table.accept(late, 5, later));
    EXPECT_FALSE(table.accept(late, 5, later));
}

}  // namespace
}  // namespace hazer::protocol
