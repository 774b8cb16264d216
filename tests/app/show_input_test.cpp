#include "app/show_input.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/show.h"

namespace hazer::app {
namespace {

using ::testing::HasSubstr;

std::vector<ShowInput> inputsOf(const std::string& text) {
    return parseShow(text, "a.toml").inputs;
}

std::string errorOf(const std::string& text) {
    try {
        inputsOf(text);
    } catch (const ShowError& error) {
        return error.what();
    }
    return "no error";
}

TEST(ShowInput, IsArtNetOnEveryInterfaceUnlessItSaysMore) {
    const ShowInput input = inputsOf("[[input]]").at(0);
    EXPECT_EQ(input.transport, protocol::Transport::kArtNet);
    EXPECT_EQ(input.address, "0.0.0.0");
    EXPECT_EQ(input.port, 6454);
    EXPECT_FALSE(input.isProgrammable);
    EXPECT_EQ(input.merge, protocol::MergeMode::kHighest);
    EXPECT_FALSE(input.loss.fadesOut);
}

TEST(ShowInput, ReadsMergingAndLoss) {
    const ShowInput input =
        inputsOf("[[input]]\nprotocol='artnet'\nmerge='ltp'\non_loss='fade'\nfade_s=2.5\nprogrammable=true")
            .at(0);
    EXPECT_EQ(input.merge, protocol::MergeMode::kLatest);
    EXPECT_TRUE(input.loss.fadesOut);
    EXPECT_EQ(input.loss.fadeTime, std::chrono::milliseconds(2500));
    EXPECT_TRUE(input.isProgrammable);
}

TEST(ShowInput, FadesInTwoSecondsUnlessItSaysMore) {
    EXPECT_EQ(inputsOf("[[input]]\non_loss='fade'").at(0).loss.fadeTime, std::chrono::seconds(2));
}

TEST(ShowInput, NamesEveryMistake) {
    EXPECT_THAT(errorOf("[[input]]\nmerge='highest'"), HasSubstr("a.toml:2: "));
    EXPECT_THAT(errorOf("[[input]]\nmerge='highest'"), HasSubstr("htp"));
    EXPECT_THAT(errorOf("[[input]]\non_loss='black'"), HasSubstr("hold"));
    EXPECT_THAT(errorOf("[[input]]\nfade_s=3"), HasSubstr("on_loss"));
    EXPECT_THAT(errorOf("[[input]]\non_loss='fade'\nfade_s=-1"), HasSubstr("must be 0 to 3600"));
    EXPECT_THAT(errorOf("[[input]]\nprogramable=true"), HasSubstr("programmable"));
}

TEST(ShowInput, TwoOfOneProtocolMustMergeAlike) {
    EXPECT_EQ(inputsOf("[[input]]\nmerge='ltp'\n[[input]]\nport=6455\nmerge='ltp'").size(), 2U);
    EXPECT_THAT(errorOf("[[input]]\nmerge='ltp'\n[[input]]\nport=6455"),
                HasSubstr("a.toml:3: an input of the same protocol in line 1 has another merge"));
}

TEST(ShowFixtureUniverse, HasTheRangeOfItsProtocol) {
    const auto fixture = [](const std::string& universe) {
        return "[[fixture]]\nname='a'\ngdtf='par-rgbw'\nmode='Standard'\nslot=1\n" + universe;
    };
    const auto universeOf = [&](const std::string& universe) {
        return parseShow(fixture(universe), "a.toml").fixtures.at(0).universe;
    };
    using protocol::Transport;
    EXPECT_EQ(universeOf("universe=0"), (protocol::UniverseId{Transport::kArtNet, 0}));
    EXPECT_EQ(universeOf("protocol='sacn'\nuniverse=63999"), (protocol::UniverseId{Transport::kSacn, 63999}));
    EXPECT_EQ(universeOf("protocol='dmx'\nuniverse=1"), (protocol::UniverseId{Transport::kDmx, 1}));
    EXPECT_EQ(universeOf("protocol='any'\nuniverse=7"), (protocol::UniverseId{Transport::kAny, 7}));
    EXPECT_THAT(errorOf(fixture("universe=32768")), HasSubstr("must be 0 to 32767"));
    EXPECT_THAT(errorOf(fixture("protocol='sacn'\nuniverse=0")), HasSubstr("must be 1 to 63999"));
    EXPECT_THAT(errorOf(fixture("protocol='dmx'\nuniverse=0")), HasSubstr("must be 1 to 65535"));
}

}  // namespace
}  // namespace hazer::app
