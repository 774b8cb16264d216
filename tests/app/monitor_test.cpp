#include "app/monitor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace hazer::app {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

protocol::SourceStatus source(const std::string& name) {
    protocol::SourceStatus status;
    status.name = name;
    status.address = "10.0.0.5";
    status.packetsPerS = 43.9;
    status.lossCount = 2;
    return status;
}

MonitorView twoDesks() {
    MonitorView view;
    protocol::UniverseStatus& universe = view.universes.emplace_back();
    universe.universe = {protocol::Transport::kArtNet, 0x123};
    universe.isMerging = true;
    universe.refusedSources = 7;
    universe.sources = {source("desk"), source("backup")};
    universe.sources[0].isWinning = true;
    universe.sources[0].hasSlotPriorities = true;
    universe.sources[1].isAlive = false;
    universe.look.slots[16] = 201;
    view.universes.emplace_back().universe = {protocol::Transport::kSacn, 9};
    return view;
}

protocol::SacnReport announcement(std::vector<std::uint16_t> universes) {
    protocol::SacnReport report;
    report.counters.levels = 12;
    report.counters.tooMany = 3;
    report.discovered.push_back({{}, "node", "10.0.0.9", std::move(universes), {}});
    return report;
}

TEST(MonitorTable, HasALineForEachSource) {
    const std::string table = monitorTable(twoDesks());
    EXPECT_THAT(table,
                HasSubstr("Art-Net 291 (1:2:3)    merging  desk               10.0.0.5          100+ wins"));
    EXPECT_THAT(table, HasSubstr("backup             10.0.0.5           100 gone    44/s"));
    EXPECT_THAT(table, HasSubstr("7 packets of further sources refused"));
    EXPECT_THAT(table, HasSubstr("sACN 9                 waiting"));
    EXPECT_THAT(table, Not(HasSubstr("201"))) << "slots only where they are wanted";
}

TEST(MonitorTable, NoLineIsWiderThanATerminal) {
    MonitorView view = twoDesks();
    view.universes[0].sources[0].name = std::string(64, 'x');
    view.universes[0].sources[0].address = "fe80:1234:1234:1234:1234:1234:1234:1234%enp0s31f6";
    view.showSlots = {view.universes[0].universe};
    std::vector<std::uint16_t> odd;
    for (std::uint16_t universe = 1; universe < 999; universe += 2) odd.push_back(universe);
    view.sacn = {announcement(odd)};
    const std::string table = monitorTable(view);
    for (std::size_t begin = 0; begin < table.size(); begin = table.find('\n', begin) + 1) {
        EXPECT_LE(table.find('\n', begin) - begin, 100U) << table.substr(begin, 120);
    }
}

TEST(MonitorTable, CutsNamesBetweenCharacters) {
    MonitorView view = twoDesks();
    view.universes[0].sources[0].name = "Bühnenbeleuchtungsanlage";
    EXPECT_THAT(monitorTable(view), HasSubstr("Bühnenbeleuchtungs "));
}

TEST(MonitorTable, ShowsSlotsThatAreWanted) {
    MonitorView view = twoDesks();
    view.showSlots = {view.universes[0].universe};
    EXPECT_THAT(monitorTable(view), HasSubstr("\n  17  201   0"));
}

TEST(MonitorTable, ShowsTimeCodeAndTrigger) {
    MonitorView view;
    view.artNet.timeCode =
        protocol::ReceivedTimeCode{{.hours = 1, .minutes = 2, .seconds = 3, .frames = 4}, {}, {}};
    view.artNet.trigger = protocol::ReceivedTrigger{3, 7, {}, {}};
    EXPECT_THAT(monitorTable(view), HasSubstr("time code 01:02:03:04 at 25 fps"));
    EXPECT_THAT(monitorTable(view), HasSubstr("trigger show 7"));
    EXPECT_EQ(triggerText({0, 'a', {}, {}}), "key 'a'");
    EXPECT_EQ(triggerText({0, 7, {}, {}}), "key 7");
    EXPECT_EQ(triggerText({99, 7, {}, {}}), "99 7");
}

TEST(MonitorTable, ShowsWhatSacnSourcesAnnounce) {
    MonitorView view;
    view.sacn = {announcement({1, 2, 3, 70})};
    EXPECT_THAT(monitorTable(view), HasSubstr("sACN: 12 levels, 0 late, 3 refused"));
    EXPECT_THAT(monitorTable(view), HasSubstr("node at 10.0.0.9 announces sACN 1-3,70\n"));
}

TEST(MonitorJson, SaysTheSame) {
    MonitorView view = twoDesks();
    view.sacn = {announcement({1, 70})};
    view.showSlots = {view.universes[0].universe};
    const nlohmann::ordered_json json = monitorJson(view);
    ASSERT_EQ(json["universes"].size(), 2U);
    const auto& universe = json["universes"][0];
    EXPECT_EQ(universe["protocol"], "artnet");
    EXPECT_EQ(universe["universe"], 0x123);
    EXPECT_EQ(universe["merging"], true);
    EXPECT_EQ(universe["refused_sources"], 7);
    EXPECT_EQ(universe["sources"][0]["name"], "desk");
    EXPECT_EQ(universe["sources"][0]["winning"], true);
    EXPECT_EQ(universe["sources"][1]["alive"], false);
    EXPECT_EQ(universe["slots"][16], 201);
    EXPECT_FALSE(json["universes"][1].contains("slots"));
    EXPECT_TRUE(json["timecode"].is_null());
    EXPECT_EQ(json["sacn"][0]["levels"], 12);
    EXPECT_EQ(json["sacn"][0]["announced"][0]["universes"], nlohmann::json({1, 70}));
}

}  // namespace
}  // namespace hazer::app
