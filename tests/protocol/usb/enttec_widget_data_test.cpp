#include "protocol/usb/enttec_widget_data.h"

#include <gtest/gtest.h>

#include "tests/protocol/packets.h"

namespace hazer::protocol {
namespace {

using test::Bytes;

TEST(EnttecDmx, HasAStatusBeforeTheStartCode) {
    // ofxGenericDmx takes the status for the start code, and loses slot 512.
    Bytes data(2 + 512);
    data[2] = 11;
    data.back() = 22;
    const auto dmx = parseEnttecDmx(data);
    ASSERT_TRUE(dmx);
    EXPECT_EQ(dmx->startCode, 0);
    ASSERT_EQ(dmx->slots.size(), 512U);
    EXPECT_EQ(dmx->slots.front(), 11);
    EXPECT_EQ(dmx->slots.back(), 22);
}

TEST(EnttecDmx, TellsWhatWasLost) {
    EXPECT_FALSE(parseEnttecDmx(Bytes{0, 0, 1})->queueOverflowed);
    EXPECT_TRUE(parseEnttecDmx(Bytes{1, 0, 1})->queueOverflowed);
    EXPECT_FALSE(parseEnttecDmx(Bytes{1, 0, 1})->overrun);
    EXPECT_TRUE(parseEnttecDmx(Bytes{2, 0, 1})->overrun);
    EXPECT_EQ(parseEnttecDmx(Bytes{0, 0xCC, 1})->startCode, 0xCC);
}

TEST(EnttecDmx, NeedsAStartCodeAndFitsAUniverse) {
    EXPECT_FALSE(parseEnttecDmx({}));
    EXPECT_FALSE(parseEnttecDmx(Bytes{0}));
    EXPECT_TRUE(parseEnttecDmx(Bytes{0, 0})->slots.empty());
    EXPECT_FALSE(parseEnttecDmx(Bytes(515)));
}

/// A change of state: bits are numbered from 0.
Bytes changes(std::uint8_t block, std::initializer_list<int> bits, const Bytes& values) {
    Bytes data(6);
    data[0] = block;
    for (const int bit : bits) {
        auto& byte = data[static_cast<std::size_t>(1 + bit / 8)];
        byte = static_cast<std::uint8_t>(byte | 1 << bit % 8);
    }
    data.insert(data.end(), values.begin(), values.end());
    return data;
}

TEST(EnttecChanges, CountFromTheStartCode) {
    EnttecChanges frame;
    EXPECT_TRUE(frame.apply(changes(0, {1, 3}, {10, 30})));
    EXPECT_EQ(frame.slots()[0], 10);
    EXPECT_EQ(frame.slots()[2], 30);
    EXPECT_TRUE(frame.apply(changes(2, {0}, {99})));
    EXPECT_EQ(frame.slots()[15], 99) << "index 16 of the frame";
}

// OLA does not consume the start code's value, and shifts all others.
TEST(EnttecChanges, TheStartCodeHasAValueOfItsOwn) {
    EnttecChanges frame;
    EXPECT_TRUE(frame.apply(changes(0, {0, 1, 2}, {0, 10, 20})));
    EXPECT_EQ(frame.slots()[0], 10);
    EXPECT_EQ(frame.slots()[1], 20);
}

// usbdmx-golang looks at 39 of the 40 bits.
TEST(EnttecChanges, TheFortiethBitCounts) {
    EnttecChanges frame;
    EXPECT_TRUE(frame.apply(changes(0, {39}, {77})));
    EXPECT_EQ(frame.slots()[38], 77);
}

TEST(EnttecChanges, AreTakenWholeOrNotAtAll) {
    EnttecChanges frame;
    EXPECT_TRUE(frame.apply(changes(0, {1}, {5})));
    const Slots before = frame.slots();
    EXPECT_FALSE(frame.apply(changes(0, {1, 2}, {6}))) << "a value is missing";
    EXPECT_FALSE(frame.apply(changes(0, {1}, {6, 7}))) << "a value too many";
    EXPECT_FALSE(frame.apply(changes(0, {0, 1}, {0xCC, 6}))) << "another start code";
    EXPECT_FALSE(frame.apply(changes(60, {1, 33}, {6, 6}))) << "slot 513";
    EXPECT_FALSE(frame.apply(changes(255, {39}, {6})));
    const Bytes whole = changes(0, {1}, {6});
    for (std::size_t size = 0; size < whole.size(); ++size) {
        EXPECT_FALSE(frame.apply(test::prefixOf(whole, size))) << size;
    }
    EXPECT_EQ(frame.slots(), before);
}

TEST(EnttecChanges, ReachSlot512) {
    EnttecChanges frame;
    EXPECT_TRUE(frame.apply(changes(64, {0}, {8})));
    EXPECT_TRUE(frame.apply(changes(60, {31}, {7})));
    EXPECT_EQ(frame.slots()[511], 8);
    EXPECT_EQ(frame.slots()[510], 7);
}

TEST(EnttecChanges, GoOnFromAWholeFrame) {
    EnttecChanges frame;
    frame.begin(Bytes{1, 2, 3});
    EXPECT_TRUE(frame.apply(changes(0, {2}, {20})));
    EXPECT_EQ(frame.slots()[0], 1);
    EXPECT_EQ(frame.slots()[1], 20);
    frame.begin(Bytes{9});
    EXPECT_EQ(frame.slots()[1], 0);
}

TEST(EnttecParameters, AreFirmwareAndTimes) {
    const Bytes data{44, 1, 17, 2, 40, 0xAA};
    const auto parameters = parseEnttecParameters(data);
    ASSERT_TRUE(parameters);
    EXPECT_EQ(parameters->firmware, "1.44");
    EXPECT_NEAR(parameters->breakUs, 181.4, 0.1);
    EXPECT_NEAR(parameters->markAfterBreakUs, 21.3, 0.1);
    EXPECT_EQ(parameters->framesPerS, 40);
    for (std::size_t size = 0; size < 5; ++size)
        EXPECT_FALSE(parseEnttecParameters(test::prefixOf(data, size)));
}

TEST(EnttecSerial, IsDecimalDigitsLowestPairFirst) {
    EXPECT_EQ(parseEnttecSerial(Bytes{0x67, 0x45, 0x23, 0x01}), "01234567");
    EXPECT_EQ(parseEnttecSerial(Bytes{0xFF, 0xFF, 0xFF, 0xFF}), "") << "not programmed";
    EXPECT_EQ(parseEnttecSerial(Bytes{0x0F, 0, 0, 0}), "0000000f") << "not decimal at all";
    EXPECT_FALSE(parseEnttecSerial(Bytes{1, 2, 3}));
    EXPECT_FALSE(parseEnttecSerial(Bytes{1, 2, 3, 4, 5}));
}

TEST(EnttecIdentity, IsAnIdAndAName) {
    const auto identity = parseEnttecIdentity(Bytes{0x6B, 0x6A, 'D', 'M', 'X', 0, 'x'});
    ASSERT_TRUE(identity);
    EXPECT_EQ(identity->id, 0x6A6B);
    EXPECT_EQ(identity->name, "DMX");
    EXPECT_EQ(parseEnttecIdentity(Bytes{1, 0, 'a', 0x1B, 0xC3})->name, "a\uFFFD\uFFFD");
    EXPECT_EQ(parseEnttecIdentity(Bytes(600, 'a'))->name.size(), 32U);
    EXPECT_FALSE(parseEnttecIdentity(Bytes{1}));
}

}  // namespace
}  // namespace hazer::protocol
