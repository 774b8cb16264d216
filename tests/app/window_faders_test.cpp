// Faders of hazer's own fixtures, and what a hand on them does against DMX and the show file.
#include "app/window_faders.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "app/window_held_faders.h"

namespace hazer::app {
namespace {

using ::testing::Contains;
using ::testing::Not;

Show showWith(const std::string& gdtf, const std::string& more = "") {
    return parseShow(
        fmt::format("[[fixture]]\nname='a'\ngdtf='{}'\nmode='Standard'\nuniverse=0\nslot=1\n{}\n", gdtf,
                    more),
        "folder/a.toml");
}

const Fader* find(const std::vector<Fader>& faders, const std::string& attribute) {
    const auto found = std::find_if(faders.begin(), faders.end(),
                                    [&](const Fader& fader) { return fader.attribute == attribute; });
    return found == faders.end() ? nullptr : &*found;
}

std::vector<std::string> labelsOf(const Patch& patch) {
    std::vector<std::string> labels;
    for (const Fader& fader : fadersOf(patch.fixtures().front().fixture)) labels.push_back(fader.label);
    return labels;
}

TEST(Faders, ofAMovingSpot) {
    const Patch patch(showWith("moving-spot"));
    const std::vector<Fader> faders = fadersOf(patch.fixtures().front().fixture);
    for (const char* attribute : {"Dimmer", "Shutter1", "Pan", "Tilt", "Zoom", "Focus1", "Gobo1", "Gobo1Pos",
                                  "ColorSub_C", "ColorSub_M", "ColorSub_Y", "Color1"}) {
        ASSERT_NE(find(faders, attribute), nullptr) << attribute;
        EXPECT_LT(find(faders, attribute)->from, find(faders, attribute)->to) << attribute;
    }
    EXPECT_TRUE(std::is_sorted(faders.begin(), faders.end(),
                               [](const Fader& a, const Fader& b) { return a.group < b.group; }));
    ASSERT_NE(find(faders, "Gobo1")->wheel, nullptr);
    EXPECT_EQ(find(faders, "Gobo1")->wheel->name, "Gobo Wheel");
    EXPECT_EQ(find(faders, "Color1")->wheel->name, "Color Wheel");
    EXPECT_EQ(find(faders, "Dimmer")->wheel, nullptr);
}

TEST(Faders, ofEffectsHaveTheNamesOfTheFile) {
    Patch patch(showWith("pixel-wash"));
    fixtures::Fixture& fixture = patch.fixtures().front().fixture;
    const std::vector<Fader> faders = fadersOf(fixture);
    const Fader* const effects = find(faders, "Effects1");
    ASSERT_NE(effects, nullptr);
    EXPECT_EQ(effects->group, FaderGroup::kEffect);
    ASSERT_GE(effects->names.size(), 2u);
    for (const NamedFaderValue& named : effects->names) {
        fixture.hold("Effects1", named.value);
        ASSERT_NE(fixture.set("Effects1"), nullptr) << named.name;
        EXPECT_EQ(fixture.set("Effects1")->name, named.name);
    }
    const Fader* const macro = find(faders, "ColorMacro1");
    ASSERT_NE(macro, nullptr);
    EXPECT_NE(macro->wheel, nullptr);
    EXPECT_TRUE(macro->names.empty());
}

TEST(Faders, haveANameForWhereTheyStandOnlyWhileTheyAct) {
    Patch patch(showWith("moving-spot"));
    fixtures::Fixture& fixture = patch.fixtures().front().fixture;
    fixture.hold("Shutter1", 0.0);
    ASSERT_NE(fixture.set("Shutter1"), nullptr);
    EXPECT_EQ(fixture.set("Shutter1")->name, "Closed");
    fixture.hold("Shutter1", std::nullopt);
    fixture.hold("Shutter1Strobe", 5.0);
    EXPECT_EQ(fixture.set("Shutter1"), nullptr);
    EXPECT_EQ(fixture.set("Dimmer"), nullptr);
    EXPECT_EQ(fixture.set("NoSuchAttribute"), nullptr);
}

TEST(Faders, areThoseThatTheFixtureHas) {
    const Patch par(showWith("par-rgbw"));
    EXPECT_THAT(labelsOf(par), Contains("white"));
    EXPECT_THAT(labelsOf(par), Not(Contains("pan")));
    EXPECT_THAT(labelsOf(par), Not(Contains("gobo")));
}

TEST(Faders, mixColourAsTheFixtureDoes) {
    const Patch par(showWith("par-rgbw"));
    const Patch spot(showWith("moving-spot"));
    const Patch fresnel(showWith("fresnel"));
    EXPECT_EQ(colorMixerOf(par.fixtures().front().fixture).mixing, ColorMixing::kAdditive);
    EXPECT_EQ(colorMixerOf(spot.fixtures().front().fixture).mixing, ColorMixing::kSubtractive);
    EXPECT_EQ(colorMixerOf(spot.fixtures().front().fixture).red, "ColorSub_C");
    EXPECT_EQ(colorMixerOf(fresnel.fixtures().front().fixture).mixing, ColorMixing::kNone);
    EXPECT_EQ(mixerValue(ColorMixing::kSubtractive, 0.25), 0.75);
    EXPECT_EQ(mixerValue(ColorMixing::kAdditive, 0.25), 0.25);
}

/// Open, then two gobos.
fixtures::Wheel goboWheel() {
    const auto picture = std::make_shared<const fixtures::WheelImage>();
    fixtures::Wheel wheel;
    wheel.slots.resize(3);
    wheel.slots[1].image = picture;
    wheel.slots[2].image = picture;
    return wheel;
}

TEST(GoboSwitch, takesTheGoboOutAndPutsTheSameOneBack) {
    EXPECT_EQ(slotAfterGoboSwitch(goboWheel(), 3, 3), 1);
    EXPECT_EQ(slotAfterGoboSwitch(goboWheel(), 1, 3), 3);
    EXPECT_EQ(slotAfterGoboSwitch(goboWheel(), 1, 0), 2) << "the first gobo, where none was in before";
}

TEST(GoboSwitch, staysWhereThereIsNothingToChangeTo) {
    fixtures::Wheel onlyOpen;
    onlyOpen.slots.resize(2);
    EXPECT_EQ(slotAfterGoboSwitch(onlyOpen, 2, 0), 2);
    fixtures::Wheel onlyGobos = goboWheel();
    onlyGobos.slots.erase(onlyGobos.slots.begin());
    EXPECT_EQ(slotAfterGoboSwitch(onlyGobos, 2, 2), 2);
}

class HeldFadersTest : public ::testing::Test {
 protected:
    fixtures::Fixture& fixture() { return patch_.fixtures().front().fixture; }

    void sendDimmer(double level) {
        protocol::UniverseSet universes;
        fixture().encode("Dimmer", level, universes[*firstUniverse(patch_.fixtures().front())].slots);
        patch_.decode(universes);
    }

    double valueOf(const char* attribute) { return fixture().value(attribute).value_or(-1.0); }

    const Show show_ = showWith("moving-spot", "set = { Zoom = 30.0 }");
    Patch patch_{show_};
    HeldFaders held_{show_};
};

TEST_F(HeldFadersTest, handWinsOverDmxUntilReleased) {
    sendDimmer(0.2);
    EXPECT_NEAR(valueOf("Dimmer"), 0.2, 0.01);
    held_.hold(fixture(), "Dimmer", 0.75);
    sendDimmer(0.4);
    EXPECT_NEAR(valueOf("Dimmer"), 0.75, 1e-9);
    EXPECT_TRUE(held_.isHeld(fixture(), "Dimmer"));
    EXPECT_TRUE(held_.holdsAny(fixture()));
    held_.release(fixture(), "Dimmer");
    EXPECT_NEAR(valueOf("Dimmer"), 0.4, 0.01);
    EXPECT_FALSE(held_.holdsAny(fixture()));
}

TEST_F(HeldFadersTest, releaseGoesBackToWhatTheShowHolds) {
    EXPECT_FALSE(held_.isHeld(fixture(), "Zoom")) << "held by the show, not by the hand";
    held_.hold(fixture(), "Zoom", 45.0);
    EXPECT_NEAR(valueOf("Zoom"), 45.0, 1e-9);
    held_.release(fixture(), "Zoom");
    EXPECT_NEAR(valueOf("Zoom"), 30.0, 1e-9);
}

TEST_F(HeldFadersTest, releaseAllLeavesTheShowAlone) {
    sendDimmer(0.4);
    held_.hold(fixture(), "Dimmer", 1.0);
    held_.hold(fixture(), "Zoom", 45.0);
    EXPECT_EQ(held_.count(), 2U);
    held_.releaseAll(patch_);
    EXPECT_EQ(held_.count(), 0U);
    EXPECT_NEAR(valueOf("Dimmer"), 0.4, 0.01);
    EXPECT_NEAR(valueOf("Zoom"), 30.0, 1e-9);
}

TEST_F(HeldFadersTest, doesNotHoldWhatTheFixtureLacks) {
    held_.hold(fixture(), "ColorAdd_R", 1.0);
    EXPECT_EQ(held_.count(), 0U);
}

}  // namespace
}  // namespace hazer::app
