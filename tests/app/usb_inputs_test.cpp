#include "app/usb_inputs.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "app/universe_name.h"
#include "app/usb_text.h"
#include "protocol/network_error.h"

namespace hazer::app {
namespace {

using protocol::Transport;
using protocol::UsbOthers;

Show parse(const std::string& text) {
    return parseShow(text, "folder/a.toml");
}

std::string messageOf(const std::string& text) {
    try {
        parse(text);
    } catch (const ShowError& error) {
        return error.what();
    }
    return "no ShowError";
}

std::optional<UsbWish> wishOf(const std::string& text,
                              const std::vector<protocol::UniverseId>& patched = {}) {
    return usbWishOf(parse(text).inputs, patched);
}

const char* const kLamp = "[[fixture]]\nname='a'\ngdtf='fresnel'\nmode='Standard'\nslot=1\n";

TEST(UsbInputs, NoneWithoutAWishForOne) {
    EXPECT_FALSE(wishOf(""));
    EXPECT_FALSE(wishOf("[[input]]\nport=6455", {{Transport::kArtNet, 1}}));
}

TEST(UsbInputs, AnInputTakesEveryInterface) {
    const auto wish = wishOf("[[input]]\nprotocol='usb'");
    ASSERT_TRUE(wish);
    EXPECT_TRUE(wish->isAskedFor);
    EXPECT_EQ(wish->config.others, UsbOthers::kAll);
    EXPECT_EQ(wish->config.firstUniverse, 1);
    EXPECT_EQ(wishOf("[[input]]\nprotocol='usb'\nuniverse=9")->config.firstUniverse, 9);
}

TEST(UsbInputs, ASerialNumberTakesThatInterfaceAlone) {
    const auto wish = wishOf(
        "[[input]]\nprotocol='usb'\nserial='EN1'\nuniverse=7\n"
        "[[input]]\nprotocol='usb'\nserial='EN2'");
    ASSERT_EQ(wish->config.bindings.size(), 2U);
    EXPECT_EQ(wish->config.bindings[0].serial, "EN1");
    EXPECT_EQ(wish->config.bindings[0].universe, 7);
    EXPECT_FALSE(wish->config.bindings[1].universe);
    EXPECT_EQ(wish->config.others, UsbOthers::kNone);
    EXPECT_EQ(wishOf("[[input]]\nprotocol='usb'\nserial='EN1'\n[[input]]\nprotocol='usb'")->config.others,
              UsbOthers::kAll);
}

TEST(UsbInputs, FixturesOnDmxLinesTakeThoseThatSayTheyAreForDmx) {
    for (const Transport transport : {Transport::kDmx, Transport::kAny}) {
        const auto wish = wishOf("", {{Transport::kArtNet, 1}, {transport, 1}});
        ASSERT_TRUE(wish);
        EXPECT_FALSE(wish->isAskedFor);
        EXPECT_EQ(wish->config.others, UsbOthers::kThoseThatNameDmx);
    }
}

TEST(UsbInputs, HaveNoKeysOfTheNetwork) {
    EXPECT_THAT(messageOf("[[input]]\nprotocol='usb'\nport=6454"), testing::HasSubstr("'port'"));
    EXPECT_THAT(messageOf("[[input]]\nserial='EN1'"), testing::HasSubstr("'serial'"));
    EXPECT_THAT(messageOf("[[input]]\nprotocol='usb'\nuniverse=0"), testing::HasSubstr("universe"));
}

TEST(UsbInputs, FixturesArePatchedToDmxLinesFrom1) {
    const Show show = parse(std::string(kLamp) + "protocol='dmx'\nuniverse=2");
    EXPECT_EQ(show.fixtures[0].addresses.at(0).universes.at(0), (protocol::UniverseId{Transport::kDmx, 2}));
    EXPECT_THAT(messageOf(std::string(kLamp) + "protocol='dmx'\nuniverse=0"), testing::HasSubstr("universe"));
    EXPECT_EQ(parse(std::string(kLamp) + "universe=0").fixtures[0].addresses.at(0).universes.at(0).transport,
              Transport::kArtNet);
}

TEST(UsbInputs, WithoutUsbAreRefusedInOneSentence) {
    if (protocol::UsbInput::isBuiltIn()) GTEST_SKIP() << "this hazer has USB; HAZER_USB=OFF is without";
    protocol::UniverseStore store;
    try {
        const protocol::UsbInput input({}, store);
        FAIL() << "no NetworkError";
    } catch (const protocol::NetworkError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("HAZER_USB=ON"));
    }
}

TEST(UsbText, IsTheLineOrWhatIsWrongWithIt) {
    protocol::UsbLineStatus line;
    line.key = "EN1";
    line.name = "ENTTEC DMX USB PRO";
    line.universe.number = 2;
    line.state = protocol::UsbState::kReceiving;
    line.facts.frames = 7;
    EXPECT_EQ(usbLineText(line), "DMX line 2: ENTTEC DMX USB PRO, receiving");
    EXPECT_EQ(usbLineJson(line)["serial"], "EN1");
    EXPECT_EQ(usbLineJson(line)["state"], "receiving");
    EXPECT_EQ(usbLineJson(line)["frames"], 7);
    line.state = protocol::UsbState::kFailed;
    line.problem = "USB interface X cannot be used: it was unplugged.";
    EXPECT_EQ(usbLineText(line), line.problem);
    EXPECT_EQ(usbLineJson(line)["problem"], line.problem);
}

TEST(UniverseNames, AreThoseOfTheirNetwork) {
    EXPECT_EQ(describeUniverse({Transport::kArtNet, 5}), "Port-Address 5");
    EXPECT_EQ(describeUniverse({Transport::kDmx, 2}), "DMX line 2");
    EXPECT_EQ(protocolName(Transport::kSacn), "sacn");
    EXPECT_EQ(protocolName(Transport::kAny), "any");
}

}  // namespace
}  // namespace hazer::app
