// Recordings through the real program: inspect, record and replay, as a person would.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <future>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/moment.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace hazer::app {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

test::ProcessResult hazer(const std::vector<std::string>& arguments) {
    return test::runProcess(HAZER_PROGRAM, arguments);
}

class RecordingCommand : public ::testing::Test {
 protected:
    test::TemporaryFolder folder_;
    std::string show_ = folder_.write("a.show", "OLA Show\n1 10,20\n300\n2 7\n200\n1 30,40\n").string();
};

TEST_F(RecordingCommand, InspectTellsWhatStandsAtTheEnd) {
    const test::ProcessResult result = hazer({"inspect", show_, "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    const json told = json::parse(result.output);
    std::vector<std::string> keys;
    for (const auto& item : told.items()) keys.push_back(item.key());
    EXPECT_THAT(keys, ElementsAre("duration_s", "packets", "refused", "universes"));
    EXPECT_NEAR(told["duration_s"], 0.5, 1e-9);
    EXPECT_EQ(told["packets"], 3);
    EXPECT_EQ(told["refused"], 0);
    ASSERT_EQ(told["universes"].size(), 2);
    const json& first = told["universes"][0];
    EXPECT_EQ(first["protocol"], "dmx");
    EXPECT_EQ(first["universe"], 1);
    EXPECT_EQ(first["packets"], 2);
    EXPECT_EQ(first["sources"], json::parse(R"([{"name": "a.show", "address": "", "priority": 100}])"));
    ASSERT_EQ(first["slots"].size(), 512);
    EXPECT_EQ(first["slots"][0], 30);
    EXPECT_EQ(first["slots"][1], 40);
    EXPECT_EQ(first["slots"][2], 0);
}

TEST_F(RecordingCommand, InspectGoesToAMoment) {
    const json told = json::parse(hazer({"inspect", show_, "--json", "--at", "0.3", "--as", "sacn"}).output);
    EXPECT_NEAR(told["duration_s"], 0.5, 1e-9);
    EXPECT_EQ(told["packets"], 2);
    EXPECT_EQ(told["universes"][0]["protocol"], "sacn");
    EXPECT_EQ(told["universes"][0]["slots"][0], 10);
    EXPECT_EQ(told["universes"][1]["slots"][0], 7);
}

TEST_F(RecordingCommand, MistakesAreOneSentence) {
    EXPECT_EQ(hazer({"inspect", show_, "--at", "later"}).exitCode, 1);
    EXPECT_EQ(hazer({"replay", show_, "--rate", "0"}).exitCode, 1);
    EXPECT_EQ(hazer({"replay"}).exitCode, 1);
    EXPECT_EQ(hazer({"record"}).exitCode, 1);
    EXPECT_EQ(hazer({"record", "--out", "a.pcap", "--universe", "7-1"}).exitCode, 1);
    const test::ProcessResult absent = hazer({"replay", "/nowhere/a.pcap"});
    EXPECT_EQ(absent.exitCode, 2);
    EXPECT_THAT(absent.errors, HasSubstr("hazer: /nowhere/a.pcap: the recording cannot be read"));
    const test::ProcessResult exists = hazer({"record", "--out", show_, "--for", "0.1"});
    EXPECT_EQ(exists.exitCode, 2);
    EXPECT_THAT(exists.errors, AllOf(HasSubstr("File exists"), HasSubstr("--force")));
}

// One process sends, the other records; what was recorded tells the same as what was sent.
TEST_F(RecordingCommand, WhatIsReplayedCanBeRecorded) {
    const std::string out = (folder_.path() / "night.pcap").string();
    const std::string port = std::to_string(20000 + ::getpid() % 20000);
    const std::string inputs = folder_
                                   .write("inputs.toml",
                                          "[[input]]\naddress='127.0.0.1'\n"
                                          "[[input]]\nprotocol='sacn'\ninterface='lo'\n")
                                   .string();
    auto recording = std::async(std::launch::async, [&] {
        return hazer(
            {"record", inputs, "--out", out, "--for", "4", "--port", port, "--sacn-port", "0", "--json"});
    });
    std::this_thread::sleep_for(1s);
    const test::ProcessResult sent = hazer({"replay", show_, "--port", port, "--json"});
    ASSERT_EQ(sent.exitCode, 0) << sent.errors;
    EXPECT_EQ(json::parse(sent.output)["packets"], 3);
    const test::ProcessResult recorded = recording.get();
    ASSERT_EQ(recorded.exitCode, 0) << recorded.errors;
    EXPECT_EQ(json::parse(recorded.output)["dropped"], 0);
    EXPECT_THAT(recorded.errors, AllOf(HasSubstr("recording Art-Net on UDP port " + port + ", sACN on"),
                                       HasSubstr("to " + out)));
    const json told = json::parse(hazer({"inspect", out, "--json"}).output);
    ASSERT_EQ(told["universes"].size(), 2) << told;
    EXPECT_EQ(told["universes"][0]["protocol"], "artnet");
    EXPECT_EQ(told["universes"][0]["slots"][1], 40);
    EXPECT_EQ(told["universes"][0]["sources"][0]["address"], "127.0.0.1");
    EXPECT_NEAR(told["duration_s"], 0.5, 0.2);
}

// What cannot be listened to is said, and leaves no empty file behind.
TEST_F(RecordingCommand, RecordsWhatTheInputsOfAShowHear) {
    const std::string out = (folder_.path() / "night.pcap").string();
    const std::string nowhere =
        folder_.write("nowhere.toml", "[[input]]\nprotocol='sacn'\ninterface='nowhere0'\n").string();
    const test::ProcessResult result = hazer({"record", nowhere, "--out", out, "--for", "0.1"});
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_THAT(result.errors, HasSubstr("nowhere0"));
    EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(Moment, IsReadAsPeopleWriteIt) {
    EXPECT_EQ(parseMoment("80"), 80s);
    EXPECT_EQ(parseMoment("1:20"), 80s);
    EXPECT_EQ(parseMoment("1:02:03.5"), 3723500ms);
    EXPECT_EQ(parseMoment("0.000000001"), 1ns);
    for (const char* text :
         {"", ":", "1:", ":1", "-1", "1e3", "nan", "1:60", "1:2:3:4", "1.5:20", "99999999", "1 "}) {
        EXPECT_FALSE(parseMoment(text)) << text;
    }
    EXPECT_EQ(momentText(80s), "1:20.0");
    EXPECT_EQ(momentText(3723540ms), "1:02:03.5");
}

}  // namespace
}  // namespace hazer::app
