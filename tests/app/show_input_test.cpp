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

std::string file(const std::string& more) {
    return "[[input]]\nprotocol='file'\npath='night.pcap'\n" + more;
}

ShowRecording recordingOf(const std::string& more) {
    return parseShow(file(more), "a.toml").recordings.at(0);
}

TEST(ShowRecording, PlaysByItselfAndMergesHighestUnlessItSaysMore) {
    const ShowRecording recording = recordingOf("");
    EXPECT_EQ(recording.clock, PlaybackClock::kShow);
    EXPECT_FALSE(recording.loops);
    EXPECT_EQ(recording.merging.mode, protocol::MergeMode::kHighest);
    EXPECT_FALSE(recording.merging.loss.fadesOut);
}

TEST(ShowRecording, MergesAndIsLostAsALiveInput) {
    const ShowRecording recording = recordingOf("merge='ltp'\non_loss='fade'\nfade_s=1.5");
    EXPECT_EQ(recording.merging.mode, protocol::MergeMode::kLatest);
    EXPECT_TRUE(recording.merging.loss.fadesOut);
    EXPECT_EQ(recording.merging.loss.fadeTime, std::chrono::milliseconds(1500));
    EXPECT_THAT(errorOf(file("fade_s=1")), HasSubstr("on_loss"));
    EXPECT_EQ(inputsOf(file("merge='ltp'") + "\n[[input]]").size(), 1U) << "a file is no contradiction";
}

TEST(ShowRecording, FollowsATimeCode) {
    using namespace std::chrono_literals;
    const ShowRecording recording = recordingOf("follow='timecode'\ntimecode_start='10:00:00.5'");
    EXPECT_EQ(recording.clock, PlaybackClock::kTimeCode);
    EXPECT_EQ(recording.timeCodeStart, 10h + 500ms);
    EXPECT_EQ(recordingOf("follow='timecode'").timeCodeStart, 0s);
    EXPECT_THAT(errorOf(file("follow='ltc'")), HasSubstr("timecode"));
    EXPECT_THAT(errorOf(file("follow='timecode'\ntimecode_start='10 h'")), HasSubstr("'10 h', which is no"));
    EXPECT_THAT(errorOf(file("timecode_start='1:00'")), HasSubstr("unless follow"));
    EXPECT_THAT(errorOf(file("follow='timecode'\nloop=true")), HasSubstr("loop"));
}

TEST(ShowRecording, TimeCodeNeedsAnInputThatHearsIt) {
    const std::string follows = file("follow='timecode'");
    EXPECT_THAT(errorOf(follows + "\n[[input]]\nprotocol='sacn'"),
                HasSubstr("a.toml:1: time code comes by Art-Net"));
    EXPECT_EQ(inputsOf(follows + "\n[[input]]\nprotocol='sacn'\n[[input]]").size(), 2U);
    EXPECT_EQ(inputsOf(follows).size(), 0U);
}

TEST(ShowFixtureUniverse, HasTheRangeOfItsProtocol) {
    const auto fixture = [](const std::string& universe) {
        return "[[fixture]]\nname='a'\ngdtf='par-rgbw'\nmode='Standard'\nslot=1\n" + universe;
    };
    const auto universeOf = [&](const std::string& universe) {
        return parseShow(fixture(universe), "a.toml").fixtures.at(0).addresses.at(0).universes.at(0);
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
