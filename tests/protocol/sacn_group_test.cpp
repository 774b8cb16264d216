#include "protocol/sacn_group.h"

#include <gtest/gtest.h>

#include "protocol/endpoint_text.h"

namespace hazer::protocol {
namespace {

TEST(SacnGroup, HasTheUniverseInItsLastTwoBytes) {
    EXPECT_EQ(addressText(sacnGroupV4(1, 5568)), "239.255.0.1");
    EXPECT_EQ(addressText(sacnGroupV4(7962, 5568)), "239.255.31.26");
    EXPECT_EQ(addressText(sacnGroupV4(63999, 5568)), "239.255.249.255");
    EXPECT_EQ(addressText(sacnGroupV4(64214, 5568)), "239.255.250.214");
    EXPECT_EQ(addressText(sacnGroupV6(1, 5568)), "ff18::8300:1");
    EXPECT_EQ(addressText(sacnGroupV6(63999, 5568)), "ff18::8300:f9ff");
}

TEST(SacnGroup, IsWrongOnlyForMulticastOfAnotherUniverse) {
    EXPECT_FALSE(isWrongGroup(sacnGroupV4(5, 5568), 5));
    EXPECT_FALSE(isWrongGroup(sacnGroupV6(5, 5568), 5));
    EXPECT_TRUE(isWrongGroup(sacnGroupV4(6, 5568), 5));
    EXPECT_TRUE(isWrongGroup(sacnGroupV6(6, 5568), 5));
    EXPECT_TRUE(isWrongGroup({.address = {239, 255, 255, 5}, .port = 5568}, 5));
    EXPECT_FALSE(isWrongGroup({.address = {10, 0, 0, 1}, .port = 5568}, 5)) << "unicast";
    EXPECT_FALSE(isWrongGroup({.address = {255, 255, 255, 255}, .port = 5568}, 5)) << "broadcast";
}

}  // namespace
}  // namespace hazer::protocol
