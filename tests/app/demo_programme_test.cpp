// The programme fits the demo show: its names, its attributes, what its heads can follow.
#include "app/demo_programme.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <map>
#include <string>

#include "app/patch.h"
#include "app/paths.h"
#include "app/show.h"

namespace hazer::app {
namespace {

constexpr double kFrameS = 1.0 / 44.0;

Show demoShow() {
    return loadShow(showFolder() / "demo.toml");
}

double valueOf(std::string_view fixture, std::string_view attribute, double timeS) {
    for (const AttributeValue& value : demoLook(fixture, timeS)) {
        if (value.attribute == attribute) return value.value;
    }
    return NAN;
}

TEST(DemoProgramme, everyFixtureOfTheShowHasEveryAttributeItIsAskedFor) {
    const Patch patch(demoShow());
    for (const PatchedFixture& patched : patch.fixtures()) {
        for (double timeS = 0.0; timeS < kDemoLoopS; timeS += 0.5) {
            const auto values = demoLook(patched.fixture.name(), timeS);
            ASSERT_FALSE(values.empty()) << patched.fixture.name();
            for (const AttributeValue& value : values) {
                std::array<std::uint8_t, 512> slots{};
                EXPECT_TRUE(patched.fixture.encode(value.attribute, value.value, slots))
                    << patched.fixture.name() << '.' << value.attribute;
            }
        }
    }
}

TEST(DemoProgramme, noTwoFixturesOfTheShowShareASlot) {
    EXPECT_THAT(Patch(demoShow()).overlaps(), testing::IsEmpty());
}

TEST(DemoProgramme, slotsDecodeToWhatWasAsked) {
    Patch patch(demoShow());
    fixtures::Fixture& spot = patch.find("spot3")->fixture;
    std::array<std::uint8_t, 512> slots{};
    writeDemoLook(spot, kStrikingMomentS, slots);
    spot.decode(slots);
    for (const AttributeValue& asked : demoLook("spot3", kStrikingMomentS)) {
        EXPECT_NEAR(spot.value(asked.attribute).value_or(NAN), asked.value, 0.02) << asked.attribute;
    }
}

TEST(DemoProgramme, repeatsAfterTheLoop) {
    for (const char* fixture : {"spot1", "beam6", "wash4", "par2", "blinder1", "fresnel3"}) {
        for (double timeS = 0.125; timeS < kDemoLoopS; timeS += 1.0) {
            EXPECT_NEAR(valueOf(fixture, "Dimmer", timeS), valueOf(fixture, "Dimmer", timeS + kDemoLoopS),
                        1e-9);
            EXPECT_NEAR(valueOf(fixture, "Dimmer", timeS), valueOf(fixture, "Dimmer", timeS - kDemoLoopS),
                        1e-9);
        }
    }
}

TEST(DemoProgramme, lightIsInTheAirForTheWholeFilm) {
    for (double timeS = 0.0; timeS < 10.0; timeS += kFrameS) {
        double beams = 0.0;
        for (const char* fixture : {"spot1", "spot3", "beam5", "beam8", "wash1", "wash3"}) {
            beams += valueOf(fixture, "Dimmer", timeS);
        }
        EXPECT_GT(beams, 2.0) << "at " << timeS << " s";
    }
}

TEST(DemoProgramme, headsAreNeverAskedToJump) {
    for (const char* fixture : {"spot1", "spot4", "beam1", "beam3", "beam5", "beam8", "wash2"}) {
        for (double timeS = 0.0; timeS < kDemoLoopS; timeS += kFrameS) {
            for (const char* axis : {"Pan", "Tilt"}) {
                const double before = valueOf(fixture, axis, timeS);
                EXPECT_NEAR(valueOf(fixture, axis, timeS + kFrameS), before, 6.0)
                    << fixture << '.' << axis << " at " << timeS << " s";
            }
        }
    }
}

TEST(DemoProgramme, hangingAndStandingHeadsLeanTheSameWay) {
    // Both rows open like a fan at the end of the dawn: audience left leans left, so pan has opposite signs.
    EXPECT_LT(valueOf("spot1", "Pan", 2.0), 0.0);
    EXPECT_LT(valueOf("spot1", "Tilt", 2.0), 0.0);
    EXPECT_GT(valueOf("beam5", "Pan", 2.0), 0.0);
    EXPECT_GT(valueOf("beam5", "Tilt", 2.0), 0.0);
}

TEST(DemoProgramme, doesNotKnowOtherNames) {
    for (const char* name : {"", "spot", "spot0", "spot7", "spot1b", "Spot1", "truss1", "spot99999999999"}) {
        EXPECT_THAT(demoLook(name, 1.0), testing::IsEmpty()) << name;
    }
}

}  // namespace
}  // namespace hazer::app
