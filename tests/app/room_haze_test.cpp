// Hazers fill a room and it clears again.
#include "app/room_haze.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hazer::app {
namespace {

HazeSupply supplyOf(const fixtures::HazeOutput& output) {
    HazeSupply supply;
    supply.add(output);
    return supply;
}

TEST(RoomHaze, IsNoneWithoutMachines) {
    RoomHaze room;
    room.step({}, 1000.0);
    room.settle({});
    EXPECT_EQ(room.extinctionPerM(), 0.0);
}

TEST(RoomHaze, RisesAndClears) {
    const HazeSupply on = supplyOf({.haze = 1.0});
    RoomHaze full;
    full.settle(on);
    RoomHaze room;
    double last = 0.0;
    for (int i = 0; i < 10; ++i) {
        room.step(on, 60.0);
        EXPECT_GT(room.extinctionPerM(), last);
        last = room.extinctionPerM();
    }
    EXPECT_LT(last, full.extinctionPerM());
    EXPECT_GT(last, 0.99 * full.extinctionPerM());
    room.step({}, 120.0);
    EXPECT_NEAR(room.extinctionPerM(), last / std::exp(1.0), 1e-12);
}

// However the time is cut into frames, it ends the same.
TEST(RoomHaze, IsExactForAnyStep) {
    const HazeSupply on = supplyOf({.fog = 0.7, .haze = 0.4, .fan = 0.5});
    RoomHaze inOne;
    inOne.step(on, 30.0);
    RoomHaze inMany;
    for (int i = 0; i < 3000; ++i) inMany.step(on, 0.01);
    EXPECT_NEAR(inMany.extinctionPerM(), inOne.extinctionPerM(), 1e-12);
    inOne.step(on, 1e9);
    RoomHaze settled;
    settled.settle(on);
    EXPECT_EQ(inOne.extinctionPerM(), settled.extinctionPerM());
}

TEST(RoomHaze, FogComesAndGoesFasterThanHaze) {
    RoomHaze haze;
    RoomHaze fog;
    haze.settle(supplyOf({.haze = 1.0}));
    fog.settle(supplyOf({.fog = 1.0}));
    EXPECT_GT(fog.extinctionPerM(), haze.extinctionPerM());
    haze.step({}, 60.0);
    fog.step({}, 60.0);
    EXPECT_LT(fog.extinctionPerM(), haze.extinctionPerM());
}

TEST(RoomHaze, MachinesAddUpAndFansHelp) {
    HazeSupply two;
    two.add({.haze = 1.0});
    two.add({.haze = 1.0});
    RoomHaze room;
    room.settle(two);
    RoomHaze withFan;
    withFan.settle(supplyOf({.haze = 1.0, .fan = 1.0}));
    EXPECT_EQ(room.extinctionPerM(), withFan.extinctionPerM());
}

}  // namespace
}  // namespace hazer::app
