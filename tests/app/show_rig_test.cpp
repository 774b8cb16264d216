// Rigs (MVR) as shows: what is patched where, what stands in for what, and where things point.
#include "app/show_rig.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "app/aim.h"
#include "app/patch.h"
#include "app/paths.h"
#include "app/show_universes.h"
#include "app/staging.h"
#include "render/asset_list.h"
#include "tests/fixtures/description.h"
#include "tests/support/temporary_folder.h"

namespace hazer::app {
namespace {

using fixtures::testing::Description;
using protocol::Transport;
using protocol::UniverseId;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using Files = std::vector<std::pair<std::string, std::string>>;

std::string asText(const std::vector<std::uint8_t>& bytes) {
    return {bytes.begin(), bytes.end()};
}

std::string contentOf(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// A fixture of hazer's library as an archive.
std::string libraryGdtf(const char* name) {
    return asText(fixtures::testing::zipOf(
        {{"description.xml", contentOf(libraryFolder() / name / "description.xml")}}));
}

std::string descriptionGdtf(const Description& description) {
    return asText(fixtures::testing::zipOf({{"description.xml", description.xml()}}));
}

std::string fixtureXml(const std::string& name, const std::string& gdtf, const std::string& content = "",
                       const std::string& mode = "Standard") {
    return fmt::format(
        R"(<Fixture name="{}" uuid="{}"><GDTFSpec>{}</GDTFSpec><GDTFMode>{}</GDTFMode>{}</Fixture>)", name,
        name, gdtf, mode, content);
}

std::string addressXml(const std::string& address, int mvrBreak = 0) {
    return fmt::format(R"(<Addresses><Address break="{}">{}</Address></Addresses>)", mvrBreak, address);
}

std::string matrixXml(double x, double y, double z) {
    return fmt::format("<Matrix>{{1,0,0}}{{0,1,0}}{{0,0,1}}{{{},{},{}}}</Matrix>", x, y, z);
}

class RigShow : public ::testing::Test {
 protected:
    std::filesystem::path write(const std::string& objects, Files files) const {
        files.insert(
            files.begin(),
            {"GeneralSceneDescription.xml",
             R"(<GeneralSceneDescription verMajor="1" verMinor="6"><Scene><Layers><Layer><ChildList>)" +
                 objects + "</ChildList></Layer></Layers></Scene></GeneralSceneDescription>"});
        return folder_.write("rig.mvr", asText(fixtures::testing::zipOf(files)));
    }

    Show showOf(const std::string& objects, const Files& files = {}) const {
        return loadShow(write(objects, files));
    }

    test::TemporaryFolder folder_;
};

const Files kSpot{{"spot.gdtf", libraryGdtf("moving-spot")}};

glm::dvec3 lensOf(Patch& patch, std::size_t fixture = 0) {
    return glm::dvec3(patch.fixtures().at(fixture).fixture.state().beams.at(0).worldFromBeam[3]);
}

glm::dvec3 directionOf(Patch& patch, std::size_t fixture = 0) {
    patch.settle();
    return -glm::dvec3(patch.fixtures().at(fixture).fixture.state().beams.at(0).worldFromBeam[2]);
}

TEST_F(RigShow, IsAShowOfItsOwn) {
    const Show show = showOf(fixtureXml("a", "spot", matrixXml(1000, 2000, 6000) + addressXml("1.17")) +
                                 fixtureXml("b", "SPOT.gdtf", addressXml("513")),
                             kSpot);
    EXPECT_EQ(show.title, "rig");
    EXPECT_THAT(show.warnings, IsEmpty());
    ASSERT_THAT(show.fixtures, SizeIs(2));
    EXPECT_EQ(show.fixtures[0].rig->type, show.fixtures[1].rig->type) << "one file, one type in memory";
    Patch patch(show);
    EXPECT_LT(glm::distance(lensOf(patch), glm::dvec3(1.0, 2.0, 5.5)), 0.5);
    EXPECT_EQ(patch.fixtures()[0].fixture.address(), 17);
    EXPECT_EQ(show.cameras.front().name, "front");
    EXPECT_LT(show.cameras.front().camera.positionM.y, 0.0) << "the audience";
    EXPECT_THAT(show.objects, SizeIs(1)) << "a floor";
}

TEST_F(RigShow, UniverseOneIsSacnOneAndPortAddressZero) {
    const Show show =
        showOf(fixtureXml("a", "spot", addressXml("1")) + fixtureXml("b", "spot", addressXml("513")), kSpot);
    EXPECT_THAT(universesOf(show),
                ElementsAre(UniverseId{Transport::kArtNet, 0}, UniverseId{Transport::kArtNet, 1},
                            UniverseId{Transport::kSacn, 1}, UniverseId{Transport::kSacn, 2}));
    Patch patch(show);
    const auto dimmer = [&](int sacn, int artNet) {
        // Dimmer of the spot: slots 5 and 6.
        protocol::UniverseSet universes;
        if (sacn >= 0) universes[{Transport::kSacn, 1}].slots.fill(static_cast<std::uint8_t>(sacn));
        if (artNet >= 0) universes[{Transport::kArtNet, 0}].slots.fill(static_cast<std::uint8_t>(artNet));
        patch.decode(universes);
        return patch.fixtures()[0].fixture.value("Dimmer").value();
    };
    EXPECT_NEAR(dimmer(255, -1), 1.0, 1e-6);
    EXPECT_NEAR(dimmer(-1, 51), 0.2, 1e-6);
    EXPECT_NEAR(dimmer(51, 102), 0.4, 1e-6) << "the highest of both";
    EXPECT_NEAR(dimmer(102, 51), 0.4, 1e-6);
    EXPECT_NEAR(dimmer(-1, -1), 0.4, 1e-6) << "what was heard last stays";
    EXPECT_NEAR(patch.fixtures()[1].fixture.value("Dimmer").value(), 0.0, 1e-6) << "another universe";
}

TEST_F(RigShow, PanAndTiltMayBeInverted) {
    const Show show = showOf(fixtureXml("a", "spot",
                                        addressXml("1") + "<DMXInvertPan>true</DMXInvertPan>"
                                                          "<DMXInvertTilt>false</DMXInvertTilt>") +
                                 fixtureXml("b", "spot", addressXml("1")),
                             kSpot);
    EXPECT_THAT(show.warnings, IsEmpty());
    Patch patch(show);
    protocol::UniverseSet universes;
    universes[{Transport::kSacn, 1}].slots.fill(10);
    patch.decode(universes);
    const auto value = [&](std::size_t fixture, const char* attribute) {
        return patch.fixtures()[fixture].fixture.value(attribute).value();
    };
    EXPECT_NEAR(value(0, "Pan"), -value(1, "Pan"), 0.01);
    EXPECT_NEAR(value(0, "Tilt"), value(1, "Tilt"), 1e-9);
}

TEST_F(RigShow, WhatHangsOnAPartIsThere) {
    Description bar;
    bar.geometries =
        R"(<Geometry Name="Base"><Geometry Name="Hook" Position="{1,0,0,2}{0,1,0,0}{0,0,1,-1}{0,0,0,1}">
        <Geometry Name="Tip" Position="{1,0,0,0}{0,1,0,3}{0,0,1,0}{0,0,0,1}"/></Geometry></Geometry>)";
    Files files = kSpot;
    files.emplace_back("bar.gdtf", descriptionGdtf(bar));
    const auto child = [](const char* name, const char* position) {
        return fixtureXml(name, "spot", fmt::format("<ChildPosition>{}</ChildPosition>", position));
    };
    const Show show = showOf(R"(<Truss name="t"><GDTFSpec>bar</GDTFSpec><GDTFMode>Mode</GDTFMode>)" +
                                 matrixXml(0, 0, 5000) + "<ChildList>" + child("a", "Base.Hook") +
                                 child("b", "hook.tip") + child("c", "Nowhere") + "</ChildList></Truss>",
                             files);
    EXPECT_THAT(show.warnings, ElementsAre(HasSubstr("\"c\" hangs on \"Nowhere\"")));
    ASSERT_THAT(show.fixtures, SizeIs(4));
    EXPECT_EQ(show.fixtures[1].positionM, glm::dvec3(2.0, 0.0, 4.0));
    EXPECT_EQ(show.fixtures[2].positionM, glm::dvec3(2.0, 3.0, 4.0));
    EXPECT_EQ(show.fixtures[3].positionM, glm::dvec3(0.0, 0.0, 5.0));
}

TEST_F(RigShow, BelongsToAShow) {
    write(fixtureXml("a", "spot", addressXml("1")), kSpot);
    const auto load = [&](const std::string& text) { return loadShow(folder_.write("s.toml", text)); };
    const Show both =
        load("rig = 'rig.mvr'\n[[fixture]]\nname='a'\ngdtf='fresnel'\nmode='Standard'\nuniverse=9\nslot=1");
    ASSERT_THAT(both.fixtures, SizeIs(2));
    EXPECT_EQ(both.fixtures[1].name, "a (2)") << "names are unique";
    EXPECT_THAT(both.objects, IsEmpty()) << "the show says what stands there";
    EXPECT_THAT(universesOf(load("rig='rig.mvr'\nrig_protocol='sacn'")),
                ElementsAre(UniverseId{Transport::kSacn, 1}));
    EXPECT_THAT(universesOf(load("rig='rig.mvr'\nrig_protocol='artnet'")),
                ElementsAre(UniverseId{Transport::kArtNet, 0}));
    EXPECT_THROW(load("rig_protocol='sacn'"), ShowError);
    EXPECT_THROW(load("rig='gone.mvr'"), ShowError);
}

TEST_F(RigShow, NamesAreUnique) {
    const Show show =
        showOf(fixtureXml("a", "spot") + fixtureXml("a", "spot", "<FixtureID>12</FixtureID>") +
                   fixtureXml("a", "spot", "<FixtureID>12</FixtureID>") + fixtureXml("", "spot"),
               kSpot);
    std::vector<std::string> names;
    for (const ShowFixture& fixture : show.fixtures) names.push_back(fixture.name);
    EXPECT_THAT(names, ElementsAre("a", "a #12", "a (2)", show.fixtures[0].rig->type->name));
}

TEST_F(RigShow, WhatHasNoFileIsReplacedByOneOfItsKind) {
    const Show show = showOf(fixtureXml("Robe LEDWash 600", "gone.gdtf", addressXml("1")) +
                                 fixtureXml("Strobe", "", "") + fixtureXml("broken one", "broken.gdtf"),
                             {{"broken.gdtf", "no zip"}});
    ASSERT_THAT(show.fixtures, SizeIs(3));
    EXPECT_EQ(show.fixtures[0].rig->type->name,
              Patch(loadShow(folder_.write(
                        "w.toml",
                        "[[fixture]]\nname='w'\ngdtf='moving-wash'\nmode='Standard'\nuniverse=0\nslot=1")))
                  .fixtures()[0]
                  .fixture.type()
                  .name);
    EXPECT_EQ(show.fixtures[0].name, "Robe LEDWash 600");
    EXPECT_THAT(show.warnings, SizeIs(3));
    EXPECT_THAT(show.warnings[0],
                HasSubstr("\"gone.gdtf\" is neither in the rig nor beside it; hazer's 'moving-wash'"));
    EXPECT_THAT(show.warnings[1], HasSubstr("'strobe'"));
    EXPECT_THAT(show.warnings[2], HasSubstr("cannot be read"));
    EXPECT_NO_THROW(Patch{show});
}

TEST_F(RigShow, AFileBesideTheRigIsTaken) {
    folder_.write("mine.gdtf", libraryGdtf("moving-spot"));
    EXPECT_THAT(showOf(fixtureXml("a", "../../elsewhere/mine")).warnings, IsEmpty());
}

TEST_F(RigShow, DummiesAreReplaced) {
    Description dummy;
    dummy.geometries = R"(<Geometry Name="Base"/>)";
    for (int i = 1; i <= 14; ++i) {
        dummy.channels +=
            fixtures::testing::simpleChannelXml("Base", std::to_string(i), fmt::format("Dimmer{}", i), 0, 1);
    }
    const Show show = showOf(fixtureXml("Alpha Spot", "dummy", addressXml("1"), "Mode") +
                                 fixtureXml("Alpha Spot", "dummy", addressXml("20"), "Mode"),
                             {{"dummy.gdtf", descriptionGdtf(dummy)}});
    EXPECT_THAT(show.warnings, ElementsAre(HasSubstr("hazer's 'moving-spot', mode 'Basic', stands in")));
    Patch patch(show);
    EXPECT_LE(patch.fixtures()[0].fixture.mode().footprint, 14) << "it must not hear its neighbour";
    EXPECT_THAT(patch.fixtures()[0].fixture.state().beams, SizeIs(1));
}

TEST_F(RigShow, WhatHasNoLightAndNeedsNoneIsKept) {
    Description hazerOrFan;
    hazerOrFan.geometries = R"(<Geometry Name="Base"/>)";
    hazerOrFan.channels = fixtures::testing::simpleChannelXml("Base", "1", "Fog1", 0, 1);
    const Show show =
        showOf(fixtureXml("fog", "fog", "", "Mode"), {{"fog.gdtf", descriptionGdtf(hazerOrFan)}});
    EXPECT_THAT(show.warnings, IsEmpty());
    EXPECT_THAT(show.fixtures, SizeIs(1));
}

TEST_F(RigShow, AnUnknownModeIsTheFirst) {
    const Show show =
        showOf(fixtureXml("a", "spot", "", "Extended") + fixtureXml("b", "spot", "", "standard"), kSpot);
    EXPECT_EQ(show.fixtures[0].mode, "Standard");
    EXPECT_THAT(show.warnings, ElementsAre(HasSubstr("no mode \"Extended\"")));
}

TEST_F(RigShow, EveryBreakIsPatched) {
    Description lamp;
    lamp.channels =
        fixtures::testing::simpleChannelXml("Beam", "1", "Dimmer", 0, 1) +
        fixtures::testing::channelXml("Beam", "1", "ColorAdd_R",
                                      fixtures::testing::functionXml("ColorAdd_R", ""), R"(DMXBreak="2")");
    const std::string addresses =
        R"(<Addresses><Address break="0">5</Address><Address break="1">2.7</Address><Address break="2">9</Address></Addresses>)";
    const Show show =
        showOf(fixtureXml("a", "lamp", addresses, "Mode"), {{"lamp.gdtf", descriptionGdtf(lamp)}});
    ASSERT_THAT(show.fixtures.at(0).addresses, SizeIs(2)) << "the mode has no third break";
    Patch patch(show);
    protocol::UniverseSet universes;
    universes[{Transport::kSacn, 1}].slots[4] = 255;
    universes[{Transport::kSacn, 2}].slots[6] = 255;
    patch.decode(universes);
    EXPECT_EQ(patch.fixtures()[0].fixture.value("Dimmer"), 1.0);
    EXPECT_EQ(patch.fixtures()[0].fixture.value("ColorAdd_R"), 1.0);
}

TEST_F(RigShow, WhatRunsPastTheUniverseIsCutAndTold) {
    const Show show = showOf(fixtureXml("a", "spot", addressXml("510")), kSpot);
    EXPECT_THAT(show.warnings, ElementsAre(HasSubstr("slot 512")));
    EXPECT_NO_THROW(Patch{show});
}

constexpr const char* kFocusPoint =
    R"(<FocusPoint uuid="f"><Matrix>{1,0,0}{0,1,0}{0,0,1}{2000,-3000,1000}</Matrix></FocusPoint>)";

void expectAimed(Patch& patch) {
    const glm::dvec3 way = glm::dvec3(2.0, -3.0, 1.0) - lensOf(patch);
    EXPECT_LT(glm::degrees(std::acos(glm::dot(directionOf(patch), glm::normalize(way)))), 0.1);
}

TEST_F(RigShow, HeadsAimAtTheirFocusUntilDmxArrives) {
    for (const char* pose : {"{1,0,0}{0,1,0}{0,0,1}{0,0,6000}", "{1,0,0}{0,-1,0}{0,0,-1}{-4000,0,0}",
                             "{0,1,0}{0,0,1}{1,0,0}{0,500,3000}"}) {
        const Show show = showOf(
            fixtureXml("a", "spot", fmt::format("<Matrix>{}</Matrix><Focus>F</Focus>", pose)) + kFocusPoint,
            kSpot);
        Patch patch(show);
        expectAimed(patch);
    }
    Patch patch(showOf(fixtureXml("a", "spot", "<Focus>f</Focus>" + addressXml("1")) + kFocusPoint, kSpot));
    protocol::UniverseSet universes;
    universes[{Transport::kSacn, 1}].slots.fill(128);
    patch.decode(universes);
    EXPECT_LT(glm::distance(directionOf(patch), glm::dvec3(0.0, 0.0, -1.0)), 0.02);
}

TEST_F(RigShow, LampsWithoutMotorsAreHungTowardsTheirFocus) {
    Patch patch(showOf(fixtureXml("a", "lamp", matrixXml(0, 0, 5000) + "<Focus>f</Focus>") + kFocusPoint,
                       {{"lamp.gdtf", libraryGdtf("fresnel")}}));
    EXPECT_LT(
        glm::degrees(std::acos(glm::dot(directionOf(patch), glm::normalize(glm::dvec3(2.0, -3.0, -4.0))))),
        2.0);
}

TEST_F(RigShow, CommandsHoldWhatDmxDoesNotReach) {
    const auto commanded = [](const char* command) {
        return fmt::format("<CustomCommands><CustomCommand>{}</CustomCommand></CustomCommands>", command);
    };
    Description lamp;  // With a zoom that does not know its angles, as CAD programs write it.
    lamp.channels = fixtures::testing::simpleChannelXml("Beam", "1", "Zoom", 0, 1);
    Patch patch(showOf(fixtureXml("a", "lamp", commanded("Base_Zoom.Zoom.Zoom 1,f 44.0"), "Mode") +
                           fixtureXml("b", "spot", commanded("Head_Zoom.Zoom.Zoom 1,f 30.0")) +
                           fixtureXml("c", "spot", commanded("Head_Dimmer.Dimmer.Dimmer/percent,f 50")),
                       {{"lamp.gdtf", descriptionGdtf(lamp)}, kSpot.front()}));
    patch.settle();
    const auto beamOf = [&](std::size_t i) { return patch.fixtures().at(i).fixture.state().beams.at(0); };
    EXPECT_EQ(beamOf(0).beamAngleDeg, 44.0);
    EXPECT_NEAR(beamOf(1).beamAngleDeg, 30.0, 0.01);
    EXPECT_NEAR(patch.fixtures().at(2).fixture.value("Dimmer").value(), 0.5, 0.001);
}

TEST_F(RigShow, GelsColourTheBeam) {
    Patch patch(
        showOf(fixtureXml("a", "spot") + fixtureXml("b", "spot", "<Color>0.6,0.376,30</Color>"), kSpot));
    const auto colorOf = [&](std::size_t i) {
        return patch.fixtures().at(i).fixture.state().beams.at(0).colorXyz;
    };
    EXPECT_LT(colorOf(1).y, 0.5 * colorOf(0).y);
    EXPECT_LT(colorOf(1).z, 0.5 * colorOf(0).z);
}

TEST_F(RigShow, MeshesAreGivenOnceAndBrokenOnesAreLeftOut) {
    const auto chunk = [](int id, const std::string& content) {
        const auto size = static_cast<std::uint32_t>(content.size() + 6);
        std::string head{static_cast<char>(id & 255), static_cast<char>(id >> 8)};
        head.append(reinterpret_cast<const char*>(&size), 4);
        return head + content;
    };
    const std::array<float, 9> corners{0, 0, 500, 1000, 0, 500, 0, 2000, 500};
    const std::string vertices =
        chunk(0x4110, std::string("\3\0", 2) +
                          std::string(reinterpret_cast<const char*>(corners.data()), sizeof corners));
    const std::string faces = chunk(0x4120, std::string("\1\0\0\0\1\0\2\0\7\0", 10));
    const std::string mesh =
        chunk(0x4D4D, chunk(0x3D3D, chunk(0x4000, std::string("a\0", 2) + chunk(0x4100, vertices + faces))));
    const std::string object =
        R"(<SceneObject><Matrix>{1,0,0}{0,1,0}{0,0,1}{0,0,1000}</Matrix><Geometries><Geometry3D fileName="a.3ds"/>
           </Geometries></SceneObject>)";
    const Show show = showOf(object + object + R"(<Truss><Geometries><Geometry3D fileName="gone"/>
        <Geometry3D fileName="bad.glb"/><Geometry3D fileName="../../etc/passwd"/></Geometries></Truss>)",
                             {{"a.3ds", mesh}, {"bad.glb", "glTF"}});
    render::AssetList assets;
    Staging staging(show, assets);
    const Patch patch(show);
    const render::Scene scene = staging.scene(patch, controlsOf(show), 0.0);
    ASSERT_THAT(scene.instances, SizeIs(3)) << "a floor and twice the mesh";
    EXPECT_EQ(scene.instances[1].mesh, scene.instances[2].mesh);
    const render::BoundingBox box =
        assets.meshBounds()[static_cast<std::size_t>(scene.instances[1].mesh)].box;
    EXPECT_NEAR(box.highM.y, 2.0f, 1e-5f);
    EXPECT_NEAR(box.lowM.z, 0.5f, 1e-5f);
    EXPECT_EQ(scene.instances[1].worldFromMesh[3].z, 1.0);
    EXPECT_THAT(staging.warnings(),
                ElementsAre(HasSubstr("\"gone\""), HasSubstr("\"bad.glb\""), HasSubstr("passwd")));
}

TEST_F(RigShow, WhatIsNoRigIsOneSentence) {
    folder_.write("bad.mvr", "<html>");
    try {
        loadShow(folder_.path() / "bad.mvr");
        FAIL();
    } catch (const ShowError& error) {
        EXPECT_THAT(error.what(), HasSubstr("bad.mvr: is no ZIP archive"));
    }
}

}  // namespace
}  // namespace hazer::app
