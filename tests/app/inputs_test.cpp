// What a show says about its inputs reaches its universes: over loopback.
#include "app/inputs.h"

#include <gtest/gtest.h>

#include <mutex>
#include <set>
#include <thread>

#include "protocol/sacn_sender.h"
#include "protocol/sender.h"
#include "tests/support/datagram.h"

namespace hazer::app {
namespace {

Show showWith(const std::string& input) {
    return parseShow(
        "[[input]]\naddress='127.0.0.1'\n" + input +
            "\n[[fixture]]\nname='a'\ngdtf='par-rgbw'\nmode='Standard'\nuniverse=3\nslot=1\n"
            "[[fixture]]\nname='b'\ngdtf='par-rgbw'\nmode='Standard'\nprotocol='any'\nuniverse=4\nslot=1\n",
        "a.toml");
}

TEST(Inputs, AsksForTheUniversesOfTheFixtures) {
    Inputs inputs(showWith(""));
    const auto status = inputs.status(protocol::Clock::now());
    ASSERT_EQ(status.size(), 2U);
    EXPECT_EQ(status[0].universe, (protocol::UniverseId{protocol::Transport::kArtNet, 3}));
    EXPECT_EQ(status[1].universe, (protocol::UniverseId{protocol::Transport::kAny, 4}));
    EXPECT_TRUE(status[0].isAskedFor);
    EXPECT_EQ(inputs.port(), 0);
}

TEST(Inputs, TakesLevelsForAnyTransport) {
    Inputs inputs(showWith(""));
    inputs.listen({.ports = {.artNet = 0, .sacn = 0}});
    protocol::ArtNetSender desk("127.0.0.1", inputs.port());
    desk.send(4, std::vector<std::uint8_t>{7, 8});
    protocol::UniverseSet set;
    for (int i = 0; i < 10000 && set.empty(); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        inputs.latch(set, protocol::Clock::now());
    }
    EXPECT_EQ((set[{protocol::Transport::kAny, 4}].slots[1]), 8);
    EXPECT_EQ(inputs.artNet().counters.dmx, 1U);
}

TEST(Inputs, ALookFadesOutIfTheShowSaysSo) {
    Inputs inputs(showWith("on_loss='fade'\nfade_s=0"));
    inputs.listen({.ports = {.artNet = 0, .sacn = 0}});
    protocol::ArtNetSender desk("127.0.0.1", inputs.port());
    desk.send(3, std::vector<std::uint8_t>{7, 8});
    protocol::UniverseSet set;
    for (int i = 0; i < 10000 && set.empty(); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        inputs.latch(set, protocol::Clock::now());
    }
    const protocol::UniverseId universe{protocol::Transport::kArtNet, 3};
    EXPECT_EQ(set[universe].slots[1], 8);
    inputs.latch(set, protocol::Clock::now() + std::chrono::seconds(11));
    EXPECT_EQ(set[universe].slots[1], 0);
}

std::string lampOn(const std::string& where) {
    return "[[fixture]]\nname='a'\ngdtf='par-rgbw'\nmode='Standard'\nslot=1\n" + where;
}

TEST(Inputs, BringSacnToItsFixtures) {
    Inputs inputs(parseShow(
        "[[input]]\nprotocol='sacn'\ninterface='lo'\n" + lampOn("protocol='sacn'\nuniverse=5"), "a.toml"));
    inputs.listen({.ports = {.artNet = 0, .sacn = 0}});
    protocol::SacnSenderConfig config;
    config.to = "127.0.0.1";
    config.port = inputs.sacnPort();
    protocol::SacnSender desk(config);
    desk.setLevels(5, std::vector<std::uint8_t>{77});
    desk.sendDue(protocol::Clock::now());
    protocol::UniverseSet set;
    for (int i = 0; i < 10000 && set.empty(); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        inputs.latch(set, protocol::Clock::now());
    }
    EXPECT_EQ((set[{protocol::Transport::kSacn, 5}].slots[0]), 77);
    EXPECT_EQ(inputs.sacn().at(0).counters.levels, 1U);
}

TEST(Inputs, OfAShowWithoutAnyAreArtNetForAPatchWithoutSacn) {
    for (const std::string& text : {std::string(), lampOn("universe=5")}) {
        Inputs inputs(parseShow(text, "a.toml"));
        inputs.listen({.ports = {.artNet = 0, .sacn = 0}});
        EXPECT_NE(inputs.port(), 0) << text;
        EXPECT_EQ(inputs.sacnPort(), 0) << text;
    }
}

TEST(Inputs, HearTheTimeCodeThatARecordingFollows) {
    const std::string sacn = lampOn("protocol='sacn'\nuniverse=5\n");
    const auto hearsTimeCode = [&](const std::string& more) {
        Inputs inputs(parseShow(sacn + "[[input]]\nprotocol='file'\npath='a.pcap'\n" + more, "a.toml"));
        inputs.listen({.ports = {.artNet = 0, .sacn = 0}});
        return inputs.hearsTimeCode();
    };
    EXPECT_FALSE(hearsTimeCode(""));
    EXPECT_TRUE(hearsTimeCode("follow='timecode'"));
}

TEST(Inputs, OfWhateverThereIs) {
    const std::vector<ShowInput> inputs = everyInput();
    EXPECT_EQ(inputs.at(0).transport, protocol::Transport::kArtNet);
    EXPECT_EQ(inputs.at(1).transport, protocol::Transport::kSacn);
    EXPECT_EQ(inputs.at(1).port, protocol::kSacnPort);
    EXPECT_EQ(inputs.size(), protocol::UsbInput::isBuiltIn() ? 3U : 2U);
}

/// The addresses that a recording needs come from the show: nothing outside loopback reaches these.
TEST(Inputs, HandEverythingToATap) {
    Inputs inputs(
        parseShow("[[input]]\naddress='127.0.0.1'\n[[input]]\nprotocol='sacn'\ninterface='lo'", "a.toml"));
    std::mutex mutex;
    std::set<std::uint16_t> heardAt;
    const auto tap = [&](const protocol::Datagram& datagram) {
        const std::lock_guard lock(mutex);
        heardAt.insert(datagram.to.port);
    };
    inputs.listen({.ports = {.artNet = 0, .sacn = 0}, .tap = tap});
    protocol::ArtNetSender("127.0.0.1", inputs.port()).send(3, std::vector<std::uint8_t>{7});
    test::sendDatagram(inputs.sacnPort(), "garbage is recorded, too");
    const auto heard = [&] {
        const std::lock_guard lock(mutex);
        return heardAt;
    };
    for (int i = 0; i < 10000 && heard().size() < 2; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_EQ(heard(), (std::set<std::uint16_t>{inputs.port(), inputs.sacnPort()}));
}

}  // namespace
}  // namespace hazer::app
