#include "app/number_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hazer::app {
namespace {

using ::testing::ElementsAre;

TEST(NumberList, HoldsNumbersAndRangesOnceEach) {
    EXPECT_THAT(parseNumberList("7", 1, 100).value(), ElementsAre(7));
    EXPECT_THAT(parseNumberList("1-4", 1, 100).value(), ElementsAre(1, 2, 3, 4));
    EXPECT_THAT(parseNumberList("70,1-3,2,70", 1, 100).value(), ElementsAre(1, 2, 3, 70));
    EXPECT_EQ(parseNumberList("0-65535", 0, 65535).value().size(), 65536U);
}

TEST(NumberList, IsNothingElse) {
    for (const char* text : {"", ",", "1,", ",1", "-", "1-", "-1", "4-1", "1--2", "1 2", "x", "1-2-3", "0",
                             "101", "1-101", "65536", "99999999999", "+1"}) {
        EXPECT_FALSE(parseNumberList(text, 1, 100)) << text;
    }
}

TEST(NumberList, IsWrittenAsItIsRead) {
    for (const char* text : {"7", "1-4", "1-3,70", "1,3,5-6", "65534-65535"}) {
        EXPECT_EQ(numberListText(parseNumberList(text, 0, 65535).value()), text);
    }
    EXPECT_EQ(numberListText({}), "none");
}

}  // namespace
}  // namespace hazer::app
