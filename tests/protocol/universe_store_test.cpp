#include "protocol/universe_store.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include "tests/protocol/allocation_counter.h"

namespace hazer::protocol {
namespace {

const UniverseId kFirst{Transport::kArtNet, 0};
const UniverseId kSecond{Transport::kArtNet, 1};
const TimePoint kStart{std::chrono::hours(1)};

void set(UniverseStore& store, UniverseId universe, std::span<const std::uint8_t> slots, TimePoint now) {
    Levels levels;
    levels.universe = universe;
    levels.slots = slots;
    store.change([&](UniverseMerger& merger) { EXPECT_EQ(merger.show(levels, now), Verdict::kTaken); });
}

TEST(UniverseStore, IsEmptyAtFirst) {
    UniverseStore store;
    UniverseSet latched;
    store.latch(latched, kStart);
    EXPECT_TRUE(latched.empty());
}

TEST(UniverseStore, KeepsTheLastPacketOfEachUniverse) {
    UniverseStore store;
    set(store, kFirst, std::vector<std::uint8_t>(512, 9), kStart);
    set(store, kSecond, std::vector<std::uint8_t>{7}, kStart);
    set(store, kFirst, std::vector<std::uint8_t>{1, 2}, kStart + std::chrono::seconds(1));
    UniverseSet latched;
    store.latch(latched, kStart + std::chrono::seconds(1));
    ASSERT_EQ(latched.size(), 2U);
    EXPECT_EQ(latched[kFirst].slotCount, 2);
    EXPECT_EQ(latched[kFirst].slots[1], 2);
    EXPECT_EQ(std::ranges::count(latched[kFirst].slots, 0), 510);
    EXPECT_EQ(latched[kFirst].packetCount, 2U);
    EXPECT_EQ(latched[kFirst].lastReceived, kStart + std::chrono::seconds(1));
    EXPECT_EQ(latched[kSecond].slots[0], 7);
}

TEST(UniverseStore, ALatchedSetDoesNotChange) {
    UniverseStore store;
    set(store, kFirst, std::vector<std::uint8_t>{1}, kStart);
    UniverseSet latched;
    store.latch(latched, kStart);
    set(store, kFirst, std::vector<std::uint8_t>{2}, kStart);
    EXPECT_EQ(latched[kFirst].slots[0], 1);
}

TEST(UniverseStore, ALatchDropsWhatTheStoreDoesNotHave) {
    UniverseStore store;
    UniverseSet latched;
    latched[kFirst].slotCount = 4;
    store.latch(latched, kStart);
    EXPECT_TRUE(latched.empty());
}

TEST(UniverseStore, LatchDoesNotAllocateOnceTheSetIsWarm) {
    UniverseStore store;
    for (std::uint16_t i = 0; i < 100; ++i) {
        set(store, {Transport::kArtNet, i}, std::vector<std::uint8_t>{1}, kStart);
    }
    UniverseSet latched;
    const std::size_t beforeWarmUp = test::allocationCount();
    store.latch(latched, kStart);
    const std::size_t afterWarmUp = test::allocationCount();
    EXPECT_GE(afterWarmUp - beforeWarmUp, 100U) << "the counter does not count";
    for (int frame = 0; frame < 10; ++frame) store.latch(latched, kStart);
    EXPECT_EQ(test::allocationCount(), afterWarmUp);
    EXPECT_EQ(latched.size(), 100U);
}

// One writer, always first universe before second, always all slots of one packet alike.
void writeAlternately(UniverseStore& store, const std::atomic<bool>& stop) {
    Slots slots{};
    for (std::uint8_t value = 0; !stop; ++value) {
        slots.fill(value);
        set(store, kFirst, slots, kStart);
        set(store, kSecond, slots, kStart);
    }
}

TEST(UniverseStore, ALatchUnderAWriterIsOneConsistentSet) {
    UniverseStore store;
    std::atomic<bool> stop = false;
    std::thread writer([&] { writeAlternately(store, stop); });
    UniverseSet latched;
    std::uint64_t lastCount = 0;
    while (lastCount < 2000) {
        store.latch(latched, kStart);
        const Universe& first = latched[kFirst];
        const Universe& second = latched[kSecond];
        EXPECT_EQ(std::ranges::count(first.slots, first.slots[0]), 512) << "a torn packet";
        EXPECT_LE(first.packetCount - second.packetCount, 1U) << "universes of different moments";
        EXPECT_GE(first.packetCount, lastCount);
        lastCount = first.packetCount;
    }
    stop = true;
    writer.join();
}

}  // namespace
}  // namespace hazer::protocol
