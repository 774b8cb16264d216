// Which table lies where, and which has to go.
#include "render/gobo_table_slots.h"

#include <gtest/gtest.h>

namespace hazer::test {
namespace {

using render::GoboTableKey;
using render::GoboTableSlot;
using render::GoboTableSlots;

GoboTableKey key(int gobo) {
    return {gobo, {}};
}

TEST(GoboTableSlots, ATableIsThereOnceItIsFilled) {
    GoboTableSlots slots(4);
    slots.beginFrame();
    EXPECT_FALSE(slots.use(key(1)));
    EXPECT_EQ(slots.place(key(1), 1), (GoboTableSlot{0, 1}));
    EXPECT_EQ(slots.use(key(1)), (GoboTableSlot{0, 1}));
    EXPECT_FALSE(slots.filled(key(1)));
    EXPECT_EQ(slots.fill(key(1)), (GoboTableSlot{0, 1}));
    EXPECT_EQ(slots.filled(key(1)), (GoboTableSlot{0, 1}));
    EXPECT_FALSE(slots.filled(key(2)));
}

TEST(GoboTableSlots, ProfilesOfOneGoboAreTablesOfTheirOwn) {
    GoboTableSlots slots(4);
    slots.beginFrame();
    EXPECT_EQ(slots.place({1, {}}, 1)->firstLayer, 0);
    EXPECT_EQ(slots.place({1, {0.8, 5.4}}, 1)->firstLayer, 1);
    EXPECT_EQ(slots.use({1, {0.8, 5.4}})->firstLayer, 1);
    EXPECT_FALSE(slots.use({1, {0.8, 5.5}}));
}

TEST(GoboTableSlots, ColoursLieSideBySide) {
    GoboTableSlots slots(8);
    slots.beginFrame();
    EXPECT_EQ(slots.place(key(1), 1), (GoboTableSlot{0, 1}));
    EXPECT_EQ(slots.place(key(2), 3), (GoboTableSlot{1, 3}));
    EXPECT_EQ(slots.place(key(3), 1), (GoboTableSlot{4, 1}));
    EXPECT_EQ(slots.layersInUse(), 5);
}

TEST(GoboTableSlots, TheLongestUnusedHasToGo) {
    GoboTableSlots slots(3);
    for (int gobo = 0; gobo < 3; ++gobo) {
        slots.beginFrame();
        EXPECT_TRUE(slots.place(key(gobo), 1));
        slots.fill(key(gobo));
    }
    slots.beginFrame();
    EXPECT_TRUE(slots.use(key(0)));
    EXPECT_EQ(slots.place(key(3), 1)->firstLayer, 1);
    EXPECT_FALSE(slots.filled(key(1)));
    EXPECT_TRUE(slots.filled(key(0)));
    EXPECT_TRUE(slots.filled(key(2)));
}

TEST(GoboTableSlots, WhatThisFrameUsesStays) {
    GoboTableSlots slots(2);
    slots.beginFrame();
    EXPECT_TRUE(slots.place(key(0), 1));
    EXPECT_TRUE(slots.place(key(1), 1));
    EXPECT_FALSE(slots.place(key(2), 1));
    EXPECT_TRUE(slots.use(key(0)));
    EXPECT_TRUE(slots.use(key(1)));
    slots.beginFrame();
    EXPECT_TRUE(slots.use(key(1)));
    EXPECT_EQ(slots.place(key(2), 1)->firstLayer, 0);
}

TEST(GoboTableSlots, NeverMoreThanItsLayers) {
    GoboTableSlots slots(5);
    for (int frame = 0; frame < 200; ++frame) {
        slots.beginFrame();
        const int layers = frame % 3 == 0 ? 3 : 1;
        const auto slot = slots.place(key(frame), layers);
        ASSERT_TRUE(slot);
        EXPECT_GE(slot->firstLayer, 0);
        EXPECT_LE(slot->firstLayer + slot->layers, 5);
        EXPECT_LE(slots.layersInUse(), 5);
    }
    slots.beginFrame();
    EXPECT_FALSE(slots.place(key(1000), 6));
}

TEST(GoboTableSlots, ATableThatComesTooLateIsLeftOut) {
    GoboTableSlots slots(1);
    slots.beginFrame();
    EXPECT_TRUE(slots.place(key(0), 1));
    slots.beginFrame();
    EXPECT_TRUE(slots.place(key(1), 1));
    EXPECT_FALSE(slots.fill(key(0)));
    EXPECT_TRUE(slots.fill(key(1)));
}

}  // namespace
}  // namespace hazer::test
