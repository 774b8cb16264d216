#include "app/show_universes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hazer::app {
namespace {

using protocol::Transport;
using protocol::UniverseId;
using ::testing::ElementsAre;

TEST(ShowUniverses, AreEachNamedOnce) {
    Show show;
    for (const UniverseId universe : {UniverseId{Transport::kSacn, 3}, UniverseId{Transport::kArtNet, 7},
                                      UniverseId{Transport::kSacn, 3}}) {
        show.fixtures.emplace_back().addresses = {ShowAddress{1, {universe}, 1}};
    }
    EXPECT_THAT(universesOf(show),
                ElementsAre(UniverseId{Transport::kArtNet, 7}, UniverseId{Transport::kSacn, 3}));
}

TEST(ShowUniverses, AreAskedForOnlyWhereTheTransportHasTheNumber) {
    const std::vector<UniverseId> universes{{Transport::kArtNet, 7},  {Transport::kSacn, 3},
                                            {Transport::kAny, 0},     {Transport::kAny, 5},
                                            {Transport::kAny, 40000}, {Transport::kAny, 64000}};
    EXPECT_THAT(numbersOn(Transport::kArtNet, universes), ElementsAre(7, 0, 5));
    EXPECT_THAT(numbersOn(Transport::kSacn, universes), ElementsAre(3, 5, 40000));
}

}  // namespace
}  // namespace hazer::app
