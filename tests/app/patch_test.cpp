// Shows patched with fixtures of hazer's library: where beams point, and what mistakes are told.
#include "app/patch.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/assignment.h"
#include "app/fixture_library.h"
#include "tests/support/temporary_folder.h"

namespace hazer::app {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string fixtureText(const std::string& name, const std::string& gdtf, int slot,
                        const std::string& more = "") {
    return fmt::format("[[fixture]]\nname='{}'\ngdtf='{}'\nmode='Standard'\nuniverse=0\nslot={}\n{}\n", name,
                       gdtf, slot, more);
}

Patch patchOf(const std::string& text) {
    return Patch(parseShow(text, "folder/a.toml"));
}

std::string errorOf(const std::string& text) {
    try {
        patchOf(text);
    } catch (const ShowError& error) {
        return error.what();
    }
    return "no error";
}

glm::dvec3 beamDirection(Patch& patch, const std::string& name) {
    patch.settle();
    return -glm::dvec3(patch.find(name)->fixture.state().beams.at(0).worldFromBeam[2]);
}

void expectDirection(const glm::dvec3& direction, const glm::dvec3& expected) {
    EXPECT_NEAR(glm::distance(direction, glm::normalize(expected)), 0.0, 1e-3)
        << fmt::format("points to ({:.3f}, {:.3f}, {:.3f})", direction.x, direction.y, direction.z);
}

TEST(Library, hasTheFixturesThatComeWithHazer) {
    EXPECT_THAT(libraryFixtures(), Contains("moving-spot"));
    EXPECT_THAT(libraryFixtures(), Contains("par-rgbw"));
    EXPECT_FALSE(findLibraryFixture("../library/moving-spot")) << "a name must not lead out of the library";
}

TEST(Patch, hungFixtureShinesDown) {
    Patch patch = patchOf(fixtureText("a", "moving-spot", 1));
    expectDirection(beamDirection(patch, "a"), {0.0, 0.0, -1.0});
}

TEST(Patch, inertiaCanBeSwitchedOff) {
    const std::string fixture = fixtureText("a", "moving-spot", 1);
    for (const bool hasInertia : {true, false}) {
        Patch patch = patchOf((hasInertia ? "" : "inertia = false\n") + fixture);
        fixtures::Fixture& head = patch.find("a")->fixture;
        head.hold("Tilt", 90.0);
        patch.step(0.1);
        const double down = head.state().beams.at(0).worldFromBeam[2].z;
        EXPECT_EQ(down < 0.01, !hasInertia);
    }
}

TEST(Patch, readsDefinitionsOfOtherPrograms) {
    const test::TemporaryFolder folder;
    folder.write("lamp.qxf",
                 R"(<FixtureDefinition><Model>Lamp</Model><Channel Name="Dimmer" Preset="IntensityDimmer"/>
              <Mode Name="Standard"><Channel Number="0">Dimmer</Channel></Mode></FixtureDefinition>)");
    folder.write("lamp.json",
                 R"({"name": "Lamp", "availableChannels": {"Dimmer": {"capability": {"type": "Intensity"}}},
              "modes": [{"name": "Standard", "channels": ["Dimmer"]}]})");
    for (const char* file : {"lamp.qxf", "lamp.json"}) {
        Patch patch(parseShow(fixtureText("a", file, 1, "set = { Dimmer = 1.0 }"), folder.path() / "a.toml"));
        EXPECT_GT(patch.find("a")->fixture.state().beams.at(0).fluxLm, 0.0) << file;
    }
}

TEST(Patch, tiltTurnsAboutTheFixturesX) {
    // GDTF: a positive turn about +X takes the downward beam (-Z) towards +Y.
    Patch patch = patchOf(fixtureText("a", "moving-spot", 1, "set={Tilt=45}"));
    expectDirection(beamDirection(patch, "a"), {0.0, 1.0, -1.0});
}

TEST(Patch, panTurnsAboutTheFixturesZ) {
    Patch patch = patchOf(fixtureText("a", "moving-spot", 1, "set={Pan=90, Tilt=45}"));
    expectDirection(beamDirection(patch, "a"), {-1.0, 0.0, -1.0});
}

TEST(Patch, aStandingFixtureShinesUp) {
    Patch patch = patchOf(fixtureText("a", "moving-spot", 1, "rotation=[180,0,0]\nset={Tilt=30}"));
    expectDirection(beamDirection(patch, "a"), {0.0, -0.5, std::sqrt(0.75)});
}

TEST(Patch, positionMovesTheLens) {
    Patch low = patchOf(fixtureText("a", "moving-spot", 1));
    Patch high = patchOf(fixtureText("a", "moving-spot", 1, "position=[1,2,6]"));
    const auto lens = [](Patch& patch) {
        return glm::dvec3(patch.find("a")->fixture.state().beams.at(0).worldFromBeam[3]);
    };
    EXPECT_NEAR(glm::distance(lens(high) - lens(low), glm::dvec3(1.0, 2.0, 6.0)), 0.0, 1e-9);
}

TEST(Patch, decodesTheUniverseOfEachFixture) {
    Patch patch = patchOf(fixtureText("a", "par-rgbw", 1));
    protocol::UniverseSet universes;
    universes[{protocol::Transport::kArtNet, 1}].slots.fill(255);
    patch.decode(universes);
    EXPECT_EQ(patch.find("a")->fixture.state().beams.at(0).fluxLm, 0.0) << "universe 1 is another's";
    universes[{protocol::Transport::kArtNet, 0}].slots.fill(255);
    patch.decode(universes);
    EXPECT_NEAR(patch.find("a")->fixture.value("Dimmer").value(), 1.0, 1e-6);
}

TEST(Patch, listsTheLibrary) {
    const std::string error = errorOf("\n" + fixtureText("a", "moving-spt", 1));
    EXPECT_THAT(error, StartsWith("folder/a.toml:2: fixture 'a': there is no GDTF 'moving-spt'"));
    EXPECT_THAT(error, HasSubstr("Did you mean 'moving-spot'?"));
}

TEST(Patch, listsTheModes) {
    const std::string error =
        errorOf("[[fixture]]\nname='a'\ngdtf='moving-spot'\nmode='Extended'\nuniverse=0\nslot=1");
    EXPECT_THAT(error, StartsWith("folder/a.toml:1: fixture 'a': "));
    EXPECT_THAT(error, HasSubstr("Standard"));
}

TEST(Patch, refusesAFixtureThatDoesNotFitItsUniverse) {
    EXPECT_THAT(errorOf(fixtureText("a", "moving-spot", 510)), StartsWith("folder/a.toml:1: fixture 'a': "));
}

TEST(Patch, listsTheAttributesThatCanBeSet) {
    const std::string error = errorOf(fixtureText("a", "moving-spot", 1, "set={Dimer=1}"));
    EXPECT_THAT(error, HasSubstr("mode 'Standard' has no attribute 'Dimer'. Did you mean 'Dimmer'?"));
}

TEST(Patch, overlapsAreFoundOnce) {
    const Patch patch = patchOf(fixtureText("a", "par-rgbw", 1) + fixtureText("b", "par-rgbw", 2) +
                                fixtureText("c", "par-rgbw", 100));
    EXPECT_THAT(patch.overlaps(), ElementsAre("'a' and 'b' share slot 2 of universe 0"));
}

TEST(Assign, holdsAValueByHand) {
    Patch patch = patchOf(fixtureText("spot.1", "moving-spot", 1));
    assign("spot.1.Tilt=30", patch);
    EXPECT_EQ(patch.find("spot.1")->fixture.value("Tilt"), 30.0);
}

TEST(Assign, reachesEveryFixtureThatHasTheAttribute) {
    Patch patch = patchOf(fixtureText("a", "moving-spot", 1) + fixtureText("b", "fresnel", 100));
    assign("*.Dimmer=0.5", patch);
    assign("*.Tilt=30", patch);
    EXPECT_EQ(patch.find("a")->fixture.value("Dimmer"), 0.5);
    EXPECT_EQ(patch.find("b")->fixture.value("Dimmer"), 0.5);
    EXPECT_EQ(patch.find("a")->fixture.value("Tilt"), 30.0);
    EXPECT_THROW(assign("*.Dimer=1", patch), std::runtime_error);
}

TEST(Patch, eachBreakHasItsOwnUniverse) {
    const std::string fixture = fixtureText("a", "fresnel", 1);
    EXPECT_EQ(parseShow(fixture + "[[fixture.break]]\nnumber=3\nuniverse=7\nslot=9", "a.toml")
                  .fixtures.at(0)
                  .addresses.at(1)
                  .universes.at(0)
                  .number,
              7);
    const std::string twice = "[[fixture.break]]\nnumber=2\nuniverse=1\nslot=1\n";
    EXPECT_THAT(errorOf(fixture + twice + twice), HasSubstr("break 2 is there twice"));
    EXPECT_THROW(patchOf(fixture + "[[fixture.break]]\nnumber=1\nuniverse=1\nslot=1"), ShowError);
}

TEST(Assign, saysWhatThereIs) {
    Patch patch = patchOf(fixtureText("spot1", "moving-spot", 1));
    const auto errorOfAssign = [&](const std::string& text) -> std::string {
        try {
            assign(text, patch);
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "no error";
    };
    EXPECT_THAT(errorOfAssign("spot2.Tilt=1"), HasSubstr("Did you mean 'spot1'?"));
    EXPECT_THAT(errorOfAssign("spot1.Tild=1"), HasSubstr("Did you mean 'Tilt'?"));
}

TEST(Assign, isCheckedBeforeAnythingIsOpened) {
    EXPECT_EQ(checkAssignment("spot1.Tilt=-30.5"), "");
    for (const char* text : {"", "spot1", "spot1.Tilt", "spot1.Tilt=", "spot1.Tilt=a", "spot1.Tilt=1x",
                             ".Tilt=1", "spot1.=1", "Tilt=1", "spot1.Tilt=nan", "spot1.Tilt=inf"}) {
        EXPECT_NE(checkAssignment(text), "") << text;
    }
}

}  // namespace
}  // namespace hazer::app
