// The real program, run as a person would: exit codes, and sentences that say what to mend. Nothing here
// reaches OpenGL.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/paths.h"
#include "protocol/receiver.h"
#include "protocol/sacn_receiver.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace hazer::app {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

test::ProcessResult hazer(const std::vector<std::string>& arguments,
                          const std::map<std::string, std::string>& environment = {}) {
    return test::runProcess(HAZER_PROGRAM, arguments, environment);
}

/// One sentence on stderr, nothing on stdout, exit code 2.
void expectBadInput(const test::ProcessResult& result, const std::string& file) {
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_EQ(result.output, "");
    EXPECT_THAT(result.errors, AllOf(StartsWith("hazer: "), HasSubstr(file)));
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
}

TEST(Program, helpBeginsWithExamples) {
    for (const char* command : {"live", "demo", "render", "send", "inspect"}) {
        const test::ProcessResult result = hazer({command, "--help"});
        EXPECT_EQ(result.exitCode, 0);
        EXPECT_THAT(result.output, StartsWith(fmt::format("Examples:\n  hazer {}", command)));
    }
    EXPECT_THAT(hazer({"--help"}).output, StartsWith("Examples:\n"));
}

TEST(Program, saysItsVersion) {
    EXPECT_THAT(hazer({"--version"}).output, StartsWith("hazer 0."));
}

TEST(Program, wrongUsageIsExitCode1) {
    EXPECT_EQ(hazer({}).exitCode, 1);
    EXPECT_EQ(hazer({"paint"}).exitCode, 1);
    EXPECT_EQ(hazer({"render"}).exitCode, 1);
    EXPECT_EQ(hazer({"render", "a.toml", "--size", "0x10"}).exitCode, 1);
    EXPECT_EQ(hazer({"render", "a.toml", "--out", "a.gif"}).exitCode, 1);
    EXPECT_EQ(hazer({"render", "a.toml", "--set", "spot1"}).exitCode, 1);
    EXPECT_EQ(hazer({"send", "--universe", "32768"}).exitCode, 1);
    EXPECT_EQ(hazer({"send", "--universes", "5-1"}).exitCode, 1);
    EXPECT_EQ(hazer({"send", "--protocol", "sacn", "--universe", "0"}).exitCode, 1);
    EXPECT_EQ(hazer({"send", "--protocol", "sacn", "--universe", "64000"}).exitCode, 1);
    EXPECT_EQ(hazer({"send", "--protocol", "sacn", "--priority", "201"}).exitCode, 1);
    EXPECT_EQ(hazer({"send", "--protocol", "sacn", "--slot-priority", "1=201"}).exitCode, 1);
    EXPECT_EQ(hazer({"send", "--protocol", "sacn", "--sync", "0"}).exitCode, 1);
    EXPECT_EQ(hazer({"send", "--protocol", "sacn", "--sync"}).exitCode, 1);
    EXPECT_EQ(hazer({"send", "--protocol", "sacn", "--sync", "1-2"}).exitCode, 1);
    EXPECT_EQ(hazer({"send", "--sync", "7000"}).exitCode, 1);
    const test::ProcessResult recording = hazer({"send", "night.pcap"});
    EXPECT_EQ(recording.exitCode, 1);
    EXPECT_THAT(recording.errors, HasSubstr("hazer replay night.pcap"));
    EXPECT_THAT(hazer({"send", "--priority", "150"}).errors, HasSubstr("needs --protocol sacn"));
    EXPECT_EQ(hazer({"send", "--pattern", "rainbow"}).exitCode, 1);
    EXPECT_EQ(hazer({"send", "--slot", "513=1"}).exitCode, 1);
    EXPECT_EQ(hazer({"send", "--slot", "1=256"}).exitCode, 1);
    EXPECT_EQ(hazer({"send", "--port", "0"}).exitCode, 1);
    EXPECT_EQ(hazer({"send", "--seconds", "nan"}).exitCode, 1);
    EXPECT_EQ(hazer({"send", "--fps", "nan", "--seconds", "0.1"}).exitCode, 1);
    EXPECT_EQ(hazer({"render", "a.toml", "--ev", "nan"}).exitCode, 1);
    EXPECT_EQ(hazer({"render", "a.toml", "--ev", "41"}).exitCode, 1);
    EXPECT_EQ(hazer({"render", "a.toml", "--listen", "nan"}).exitCode, 1);
}

TEST(Program, namesAMistypedCommand) {
    EXPECT_THAT(hazer({"paint"}).errors, HasSubstr("paint"));
    EXPECT_THAT(hazer({}).errors, StartsWith("Examples:"));
}

// A pipe blocks whoever reads it; a device may never end.
TEST(Program, aFixtureFileThatIsADevice) {
    expectBadInput(hazer({"inspect", "/dev/zero"}), "/dev/zero");
}

TEST(Program, missingShow) {
    expectBadInput(hazer({"render", "/nowhere/a.toml"}), "/nowhere/a.toml");
    expectBadInput(hazer({"inspect", "/nowhere/a.toml"}), "/nowhere/a.toml");
    expectBadInput(hazer({"live", "/nowhere/a.toml"}), "/nowhere/a.toml");
}

TEST(Program, brokenShow) {
    const test::TemporaryFolder folder;
    const std::string file = folder.write("broken.toml", "title = \"a\"\n[haze\n").string();
    expectBadInput(hazer({"render", file}), file + ":2");
}

TEST(Program, unknownKey) {
    const test::TemporaryFolder folder;
    const std::string file = folder.write("a.toml", "\n[haze]\nextinctoin = 1\n").string();
    expectBadInput(hazer({"render", file}), file + ":3: unknown key 'extinctoin'");
}

std::string showWith(const std::string& gdtf, const std::string& mode) {
    return fmt::format("[[fixture]]\nname='a'\ngdtf='{}'\nmode='{}'\nuniverse=0\nslot=1\n", gdtf, mode);
}

TEST(Program, unknownFixtureAndMode) {
    const test::TemporaryFolder folder;
    const std::string file = folder.write("a.toml", showWith("moving-sport", "Standard")).string();
    expectBadInput(hazer({"inspect", file}), "moving-spot");
    const std::string other = folder.write("b.toml", showWith("moving-spot", "Extended")).string();
    expectBadInput(hazer({"inspect", other}), "Standard");
}

TEST(Program, brokenGdtf) {
    const test::TemporaryFolder folder;
    const std::string archive = folder.write("a.gdtf", "this is no archive").string();
    expectBadInput(hazer({"inspect", archive}), "a.gdtf");
    const std::string unpacked =
        folder.write("b/description.xml", "<GDTF DataVersion=\"1.2\">").parent_path();
    expectBadInput(hazer({"inspect", unpacked}), "/b: description.xml is broken in line 1");
    const std::string show = folder.write("c.toml", showWith("a.gdtf", "Standard")).string();
    expectBadInput(hazer({"inspect", show}), show + ":1: fixture 'a'");
}

TEST(Program, missingGdtf) {
    expectBadInput(hazer({"inspect", "/nowhere/a.gdtf"}), "/nowhere/a.gdtf");
}

TEST(Program, aWindowNeedsADisplay) {
    const test::ProcessResult result = hazer({"live"}, {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_THAT(result.errors, AllOf(StartsWith("hazer: "), HasSubstr("hazer render")));
}

// The same head as everywhere: pan 90, tilt 45 points at -X and down.
TEST(Program, inspectListsFunctionsAndTheirSets) {
    const test::ProcessResult result = hazer({"inspect", "moving-spot", "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    const nlohmann::json channels = nlohmann::json::parse(result.output)["modes"][0]["channels"];
    const auto gobo = std::ranges::find_if(channels, [](const auto& c) { return c["attribute"] == "Gobo1"; });
    ASSERT_NE(gobo, channels.end());
    const nlohmann::json& function = (*gobo)["functions"][0];
    EXPECT_EQ(function["wheel"], "Gobo Wheel");
    const nlohmann::json& set = function["sets"][1];
    EXPECT_EQ(set["wheel_slot"], 2);
    EXPECT_EQ(set["slot_name"], set["name"]);
    EXPECT_EQ(set["from"], 21);
    EXPECT_EQ(set["to"], 41);
    const auto shutter =
        std::ranges::find_if(channels, [](const auto& c) { return c["attribute"] == "Shutter1"; });
    ASSERT_NE(shutter, channels.end());
    EXPECT_EQ((*shutter)["functions"][0]["sets"][0]["name"], "Closed");
    EXPECT_EQ((*shutter)["functions"][0]["sets"][0]["physical_to"], 0.0);
}

TEST(Program, inspectSaysWhatMacrosAreCalled) {
    const test::ProcessResult result = hazer({"inspect", "effect-light"});
    EXPECT_NE(result.output.find("85..169: Windmill"), std::string::npos) << result.output;
}

TEST(Program, inspectPutsAFixtureWhereItIsAskedTo) {
    const test::ProcessResult result = hazer({"inspect", "moving-spot", "--json", "--at", "Pan=90,Tilt=45"});
    EXPECT_EQ(result.exitCode, 0);
    const auto direction = nlohmann::json::parse(result.output)["modes"][0]["beams"][0]["direction"];
    EXPECT_NEAR(direction[0].get<double>(), -0.7071, 1e-3);
    EXPECT_NEAR(direction[1].get<double>(), 0.0, 1e-3);
    EXPECT_NEAR(direction[2].get<double>(), -0.7071, 1e-3);
    expectBadInput(hazer({"inspect", "moving-spot", "--json", "--at", "Pann=90"}), "Did you mean 'Pan'?");
    expectBadInput(hazer({"inspect", "moving-spot", "--json", "--at", "1:20"}), "1:20");
    expectBadInput(hazer({"inspect", "moving-spot", "--at", "Pan=90"}), "with --json for fixture files");
    EXPECT_EQ(hazer({"inspect", "moving-spot", "--at", "later"}).exitCode, 1);
}

TEST(Inspect, showAsJson) {
    const test::ProcessResult result =
        hazer({"inspect", (showFolder() / "one-spot.toml").string(), "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    const nlohmann::json json = nlohmann::json::parse(result.output);
    ASSERT_EQ(json["fixtures"].size(), 1u);
    const nlohmann::json& fixture = json["fixtures"][0];
    EXPECT_EQ(fixture["name"], "spot1");
    EXPECT_EQ(fixture["gdtf"], "moving-spot");
    EXPECT_EQ(fixture["protocol"], "artnet");
    EXPECT_EQ(fixture["universe"], 0);
    EXPECT_EQ(fixture["slots"]["Pan"].size(), 2u);
    EXPECT_GE(fixture["slots"]["Dimmer"][0], 1);
}

TEST(Inspect, bareLights) {
    const test::TemporaryFolder folder;
    const std::string lamp = "[[light]]\nname='key'\nposition=[0,0,6]\ndirection=[0,3,0]\nhalf_angle=12\n";
    const std::string file = folder.write("a.toml", lamp + "candela=20000\n").string();
    const test::ProcessResult asJson = hazer({"inspect", file, "--json"});
    ASSERT_EQ(asJson.exitCode, 0) << asJson.errors;
    const nlohmann::json light = nlohmann::json::parse(asJson.output)["lights"][0];
    EXPECT_EQ(light["name"], "key");
    EXPECT_EQ(light["candela"], 20000.0);
    EXPECT_NEAR(light["direction"][1].get<double>(), 1.0, 1e-12);
    EXPECT_NEAR(light["half_angle_deg"].get<double>(), 12.0, 1e-12);
    EXPECT_THAT(hazer({"inspect", file}).output, HasSubstr("20000 cd, half angle 12 degrees"));
    folder.write("a.toml", lamp + "lumen=900\n");
    EXPECT_THAT(hazer({"inspect", file}).output, HasSubstr("900 lm, half angle 12 degrees"));
    folder.write("a.toml",
                 "[[light]]\nname='a'\nposition=[0,0,6]\ndirection=[0,3,0]\nprofile='web'\nweb='b.ies'");
    EXPECT_THAT(hazer({"inspect", file}).output, HasSubstr("web " + (folder.path() / "b.ies").string()));
}

TEST(Inspect, libraryFixtureAsJson) {
    const test::ProcessResult result = hazer({"inspect", "moving-spot", "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    const nlohmann::json json = nlohmann::json::parse(result.output);
    EXPECT_EQ(json["manufacturer"], "hazer");
    const nlohmann::json& mode = json["modes"][0];
    EXPECT_EQ(mode["name"], "Standard");
    EXPECT_GT(mode["footprint"]["1"], 10);
    ASSERT_EQ(mode["beams"].size(), 1u);
    EXPECT_NEAR(mode["beams"][0]["direction"][2].get<double>(), -1.0, 1e-9);
    EXPECT_LT(mode["beams"][0]["position_m"][2].get<double>(), -0.3);
    EXPECT_GE(json["wheels"].size(), 2u);
}

TEST(Library, listsWhatFixturesCan) {
    const test::ProcessResult result = hazer({"library", "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    const nlohmann::json library = nlohmann::json::parse(result.output);
    EXPECT_GE(library.size(), 14u);
    for (const nlohmann::json& fixture : library) {
        EXPECT_EQ(fixture["manufacturer"], "hazer");
        EXPECT_FALSE(fixture["can"].empty()) << fixture;
        EXPECT_FALSE(fixture["modes"].empty()) << fixture;
        EXPECT_GE(fixture["modes"][0]["slots"], 1) << fixture;
    }
    const test::ProcessResult profile = hazer({"library", "moving-profile"});
    EXPECT_THAT(profile.output, HasSubstr("2 gobo wheels"));
    EXPECT_THAT(profile.output, HasSubstr("4 framing blades"));
    EXPECT_THAT(profile.output, HasSubstr("33000 lm"));
    EXPECT_THAT(profile.output, Not(HasSubstr("fresnel")));
    const test::ProcessResult unknown = hazer({"library", "moving-profil"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_THAT(unknown.errors, HasSubstr("Did you mean 'moving-profile'?"));
}

TEST(Inspect, warnsAboutOverlaps) {
    const test::TemporaryFolder folder;
    std::string second = showWith("par-rgbw", "Standard");
    second.replace(second.find("'a'"), 3, "'b'");
    const std::string file = folder.write("a.toml", showWith("par-rgbw", "Standard") + second).string();
    const test::ProcessResult result = hazer({"inspect", file});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_THAT(result.errors, HasSubstr("'a' and 'b' share slot 1 of universe 0"));
}

TEST(Send, endsAfterItsTime) {
    const auto start = std::chrono::steady_clock::now();
    const test::ProcessResult result = hazer({"send", "--port", "49152", "--seconds", "0.5", "--fps", "20"});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_EQ(result.output, "10 packets sent\n");
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

TEST(Send, speaksSacnByUnicast) {
    protocol::UniverseStore store;
    protocol::SacnReceiverConfig config;
    config.interface = "lo";
    config.port = 0;
    const protocol::SacnReceiver receiver(config, store);
    const test::ProcessResult result = hazer({"send",
                                              "--protocol",
                                              "sacn",
                                              "--universes",
                                              "1-3,63999",
                                              "--slot",
                                              "1=5",
                                              "--slot-priority",
                                              "2=0",
                                              "--priority",
                                              "120",
                                              "--sync",
                                              "7000",
                                              "--name",
                                              "Pult",
                                              "--to",
                                              "127.0.0.1",
                                              "--port",
                                              std::to_string(receiver.port()),
                                              "--seconds",
                                              "0.8"});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_THAT(result.errors, HasSubstr("sending sACN universe 1-3,63999 to 127.0.0.1"));
    const auto patience = protocol::Clock::now() + std::chrono::seconds(10);
    while (receiver.counters().terminations < 12 && protocol::Clock::now() < patience) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    const protocol::SacnReport report = receiver.report();
    const protocol::SacnCounters& seen = report.counters;
    EXPECT_EQ(seen.terminations, 12U);
    EXPECT_GE(seen.levels, 16U) << "a change, three repeats";
    EXPECT_GE(seen.slotPriorities, 16U);
    EXPECT_EQ(seen.syncs, seen.levels / 4);
    EXPECT_EQ(result.output, fmt::format("{} packets sent\n", seen.levels + seen.slotPriorities + seen.syncs +
                                                                  seen.discoveries + seen.terminations));
    EXPECT_THAT(report.discovered.at(0).universes, ::testing::ElementsAre(1, 2, 3, 63999));
    const auto status = store.status(protocol::Clock::now());
    ASSERT_EQ(status.size(), 4U);
    EXPECT_EQ(status[0].sources.at(0).name, "Pult");
    EXPECT_EQ(status[0].sources.at(0).priority, 120);
    EXPECT_EQ(status[3].look.slots[0], 5);
}

TEST(Send, sendsManyUniversesOfArtNet) {
    const test::ProcessResult result =
        hazer({"send", "--universes", "0-9", "--port", "49152", "--seconds", "0.5", "--rate", "20"});
    EXPECT_EQ(result.output, "100 packets sent\n");
}

TEST(Send, synchronizesArtNet) {
    protocol::UniverseStore store;
    protocol::ReceiverConfig config;
    config.address = "127.0.0.1";
    config.port = 0;
    const protocol::Receiver receiver(config, store);
    const test::ProcessResult result =
        hazer({"send", "--universes", "0-9", "--sync", "--port", std::to_string(receiver.port()), "--seconds",
               "0.5", "--rate", "20"});
    EXPECT_EQ(result.output, "110 packets sent\n");
    const auto patience = protocol::Clock::now() + std::chrono::seconds(10);
    while (receiver.counters().syncs < 10 && protocol::Clock::now() < patience) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_EQ(receiver.counters().dmx, 100U);
    EXPECT_EQ(receiver.counters().syncs, 10U);
    EXPECT_TRUE(store.status(protocol::Clock::now()).at(9).sources.at(0).isSynchronized);
}

TEST(Send, refusesWhatIsNoAddress) {
    const test::ProcessResult result = hazer({"send", "--to", "desk", "--seconds", "1"});
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_THAT(result.errors, HasSubstr("desk"));
}

}  // namespace
}  // namespace hazer::app
