#include "protocol/pattern.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace hazer::protocol {
namespace {

Slots slotsAt(Pattern pattern, double timeS) {
    Slots slots;
    slots.fill(77);  // what a pattern forgets to write shows
    fillPattern(pattern, timeS, slots);
    return slots;
}

TEST(Pattern, NamesAreThoseOfTheCommandLine) {
    EXPECT_EQ(patternFromName("chase"), Pattern::kChase);
    EXPECT_EQ(patternFromName("sine"), Pattern::kSine);
    EXPECT_EQ(patternFromName("strobe"), Pattern::kStrobe);
    EXPECT_EQ(patternFromName("full"), Pattern::kFull);
    EXPECT_FALSE(patternFromName(""));
    EXPECT_FALSE(patternFromName("Full"));
}

TEST(Pattern, FullIsFull) {
    EXPECT_EQ(std::ranges::count(slotsAt(Pattern::kFull, 3.7), 255), 512);
}

TEST(Pattern, StrobeIsAllOrNothingFiveTimesASecond) {
    for (int flash = 0; flash < 5; ++flash) {
        const double start = flash / 5.0;
        EXPECT_EQ(std::ranges::count(slotsAt(Pattern::kStrobe, start + 0.05), 255), 512) << flash;
        EXPECT_EQ(std::ranges::count(slotsAt(Pattern::kStrobe, start + 0.15), 0), 512) << flash;
    }
}

TEST(Pattern, ChaseLightsEveryEighthSlotAndWalksOneSlotAStep) {
    for (std::size_t step = 0; step < 20; ++step) {
        const Slots slots = slotsAt(Pattern::kChase, (static_cast<double>(step) + 0.5) / 8.0);
        for (std::size_t i = 0; i < slots.size(); ++i) ASSERT_EQ(slots[i], i % 8 == step % 8 ? 255 : 0);
    }
}

TEST(Pattern, SineIsAWaveOf16SlotsWithAPeriodOfTwoSeconds) {
    const Slots start = slotsAt(Pattern::kSine, 0.0);
    EXPECT_EQ(start[0], 128);
    EXPECT_EQ(start[12], 255);
    EXPECT_EQ(start[4], 0);
    EXPECT_EQ(start[16], start[0]);
    EXPECT_EQ(slotsAt(Pattern::kSine, 2.0), start);
    EXPECT_EQ(slotsAt(Pattern::kSine, 0.5)[0], 255);
}

TEST(Pattern, TheSameTimeGivesTheSameSlotsAtAnyTime) {
    for (const Pattern pattern : {Pattern::kChase, Pattern::kSine, Pattern::kStrobe, Pattern::kFull}) {
        for (const double timeS : {-1e9, -0.3, 0.0, 1e9, 1e300}) {
            EXPECT_EQ(slotsAt(pattern, timeS), slotsAt(pattern, timeS));
            EXPECT_EQ(std::ranges::count(slotsAt(pattern, timeS), 77), 0) << timeS;
        }
    }
}

}  // namespace
}  // namespace hazer::protocol
