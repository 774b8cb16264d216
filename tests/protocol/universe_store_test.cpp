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

TEST(UniverseStore, IsEmptyAtFirst) {
    const UniverseStore store;
    UniverseSet set;
    store.latch(set);
    EXPECT_TRUE(set.empty());
}

TEST(UniverseStore, KeepsTheLastPacketOfEachUniverse) {
    UniverseStore store;
    store.set(kFirst, std::vector<std::uint8_t>(512, 9), kStart);
    store.set(kSecond, std::vector<std::uint8_t>{7}, kStart);
    store.set(kFirst, std::vector<std::uint8_t>{1, 2}, kStart + std::chrono::seconds(1));
    UniverseSet set;
    store.latch(set);
    ASSERT_EQ(set.size(), 2U);
    EXPECT_EQ(set[kFirst].slotCount, 2);
    EXPECT_EQ(set[kFirst].slots[1], 2);
    EXPECT_EQ(std::ranges::count(set[kFirst].slots, 0), 510);
    EXPECT_EQ(set[kFirst].packetCount, 2U);
    EXPECT_EQ(set[kFirst].lastReceived, kStart + std::chrono::seconds(1));
    EXPECT_EQ(set[kSecond].slots[0], 7);
}

TEST(UniverseStore, ALatchedSetDoesNotChange) {
    UniverseStore store;
    store.set(kFirst, std::vector<std::uint8_t>{1}, kStart);
    UniverseSet set;
    store.latch(set);
    store.set(kFirst, std::vector<std::uint8_t>{2}, kStart);
    EXPECT_EQ(set[kFirst].slots[0], 1);
}

TEST(UniverseStore, ALatchDropsWhatTheStoreDoesNotHave) {
    const UniverseStore store;
    UniverseSet set;
    set[kFirst].slotCount = 4;
    store.latch(set);
    EXPECT_TRUE(set.empty());
}

TEST(UniverseStore, LatchDoesNotAllocateOnceTheSetIsWarm) {
    UniverseStore store;
    for (std::uint16_t i = 0; i < 100; ++i) {
        store.set({Transport::kArtNet, i}, std::vector<std::uint8_t>{1}, kStart);
    }
    UniverseSet set;
    const std::size_t beforeWarmUp = test::allocationCount();
    store.latch(set);
    const std::size_t afterWarmUp = test::allocationCount();
    EXPECT_GE(afterWarmUp - beforeWarmUp, 100U) << "the counter does not count";
    for (int frame = 0; frame < 10; ++frame) store.latch(set);
    EXPECT_EQ(test::allocationCount(), afterWarmUp);
    EXPECT_EQ(set.size(), 100U);
}

// One writer, always first universe before second, always all slots of one packet alike.
void writeAlternately(UniverseStore& store, const std::atomic<bool>& stop) {
    Slots slots{};
    for (std::uint8_t value = 0; !stop; ++value) {
        slots.fill(value);
        store.set(kFirst, slots, kStart);
        store.set(kSecond, slots, kStart);
    }
}

TEST(UniverseStore, ALatchUnderAWriterIsOneConsistentSet) {
    UniverseStore store;
    std::atomic<bool> stop = false;
    std::thread writer([&] { writeAlternately(store, stop); });
    UniverseSet set;
    std::uint64_t lastCount = 0;
    while (lastCount < 2000) {
        store.latch(set);
        const Universe& first = set[kFirst];
        const Universe& second = set[kSecond];
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
