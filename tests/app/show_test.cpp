#include "app/show.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace hazer::app {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

const char* const kWholeShow = R"(
title = "Whole"
background = [0.1, 0.1, 0.1]

[haze]
extinction = 0.02
scattering = 0.015
noise = 0.4
noise_scale = 3
wind = [0.1, 0.2, 0.3]
phase = {forward_g = 0.7, backward_g = -0.5, forward_weight = 0.9}

[exposure]
ev100 = 6.5

[ambient]
color = [1.0, 1.0, 1.0]
illuminance = 2.0

[[input]]
protocol = "artnet"
address = "127.0.0.1"
port = 6455

[[input]]
protocol = "sacn"
interface = "eth1"
preview = "live"
port = 5569

[[camera]]
name = "front"
position = [0, -10, 2]
target = [0, 0, 2]
fov = 40.0

[[fixture]]
name = "spot1"
gdtf = "moving-spot"
mode = "Standard"
protocol = "artnet"
universe = 3
slot = 17
position = [1, 2, 6]
rotation = [180, 0, 90]
set = {Dimmer = 1.0, Tilt = -30}

[[light]]
name = "key"
position = [0, -2, 5]
target = [0, 0, 0]
up = [0, 1, 0]
candela = 20000
profile = "soft"
half_angle = 12
beam_half_angle = 9
lens_radius = 0.05
color = [1, 0.8, 0.6]
gobo = "f.png"
gobo_rotation = 30
focus = 5
shadow = true

[[object]]
type = "floor"
size = [12, 8]
color = [0.2, 0.2, 0.2]
specular = 0.1
shininess = 60

[[object]]
type = "model"
file = "chair.glb"
further = true
)";

Show parse(const std::string& text) {
    return parseShow(text, "folder/a.toml");
}

/// What the program would say about this show.
std::string errorOf(const std::string& text) {
    try {
        parse(text);
    } catch (const ShowError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Show, readsEverything) {
    const Show show = parse(kWholeShow);
    EXPECT_EQ(show.title, "Whole");
    EXPECT_FLOAT_EQ(show.haze.scatteringPerM, 0.015f);
    EXPECT_FLOAT_EQ(show.haze.noise.scaleM, 3.0f);
    EXPECT_FLOAT_EQ(show.haze.phase.backwardG, -0.5f);
    EXPECT_FLOAT_EQ(show.exposureEv100, 6.5f);
    EXPECT_FLOAT_EQ(show.ambient.illuminanceLx, 2.0f);
    ASSERT_EQ(show.inputs.size(), 2u);
    EXPECT_EQ(show.inputs[0].transport, protocol::Transport::kArtNet);
    EXPECT_EQ(show.inputs[0].port, 6455);
    EXPECT_EQ(show.inputs[1].transport, protocol::Transport::kSacn);
    EXPECT_EQ(show.inputs[1].interface, "eth1");
    EXPECT_EQ(show.inputs[1].preview, protocol::PreviewRule::kLiveOnly);
    EXPECT_EQ(show.inputs[1].port, 5569);
    EXPECT_NEAR(show.camera("front").camera.verticalFovRad, glm::radians(40.0), 1e-12);
    ASSERT_EQ(show.fixtures.size(), 1u);
    EXPECT_EQ(show.fixtures[0].addresses.at(0).universes.at(0).number, 3);
    EXPECT_EQ(show.fixtures[0].held.at("Tilt"), -30.0);
    ASSERT_EQ(show.objects.size(), 2u);
    EXPECT_FALSE(show.objects[0].castsShadow) << "a floor casts no shadow unless asked to";
    EXPECT_EQ(show.objects[1].modelFile, "folder/chair.glb");
    EXPECT_TRUE(show.objects[1].isFurther);
}

TEST(Show, anEmptyFileIsAnEmptyRoomWithACamera) {
    const Show show = parse("");
    EXPECT_EQ(show.title, "a");
    EXPECT_EQ(show.cameras.size(), 1u);
    EXPECT_TRUE(show.fixtures.empty());
}

TEST(Show, scatteringIsExtinctionUnlessGiven) {
    EXPECT_FLOAT_EQ(parse("[haze]\nextinction = 0.03").haze.scatteringPerM, 0.03f);
}

TEST(Show, aPhaseOfOneLobe) {
    const render::PhaseFunction forward = parse("[haze]\nphase={g=0.7}").haze.phase;
    EXPECT_EQ(forward.forwardG, 0.7f);
    EXPECT_EQ(forward.forwardWeight, 1.0f);
    const render::PhaseFunction backward = parse("[haze]\nphase={g=-0.4}").haze.phase;
    EXPECT_EQ(backward.backwardG, -0.4f);
    EXPECT_EQ(backward.forwardWeight, 0.0f);
    for (const char* both : {"g=0.7, forward_g=0.7", "backward_g=0, g=0", "g=0.1, forward_weight=1"}) {
        EXPECT_THAT(
            errorOf(fmt::format("\n[haze]\nphase={{{}}}", both)),
            ::testing::MatchesRegex("folder/a.toml:3: .phase. has both 'g' and '.*'; keep one of them"));
    }
    EXPECT_THAT(errorOf("[haze]\nphase={g=1}"),
                HasSubstr("'g' in [phase] is 1, which must be -0.99 to 0.99"));
    EXPECT_THAT(errorOf("[haze]\nphase={g=nan}"), HasSubstr("'g' in [phase] is nan"));
}

TEST(Show, hazeThatRolls) {
    const render::Haze plain = parse("").haze;
    EXPECT_EQ(plain.noise.turbulence, 1.0f);
    EXPECT_EQ(plain.noise.seed, 1u);
    EXPECT_FALSE(plain.deltaEddington);
    const render::Haze haze = parse("[haze]\nturbulence=2.5\nseed=2147483647\ndelta_eddington=true").haze;
    EXPECT_EQ(haze.noise.turbulence, 2.5f);
    EXPECT_EQ(haze.noise.seed, 2147483647u);
    EXPECT_TRUE(haze.deltaEddington);
    EXPECT_THAT(errorOf("[haze]\nseed=2147483648"), HasSubstr("must be 0 to 2147483647"));
    EXPECT_THAT(errorOf("[haze]\nseed=-1"), HasSubstr("must be 0 to 2147483647"));
    EXPECT_THAT(errorOf("[haze]\nseed=1.5"), HasSubstr("must be a whole number"));
    EXPECT_THAT(errorOf("[haze]\nturbulence=4.1"), HasSubstr("must be 0 to 4"));
    EXPECT_THAT(errorOf("[haze]\ndelta_eddington=1"), HasSubstr("must be true or false"));
}

TEST(Show, hazeAsThickAsItGets) {
    const render::Haze haze = parse("[haze]\nextinction=10\nscattering=10").haze;
    EXPECT_EQ(haze.extinctionPerM, 10.0f);
    EXPECT_EQ(haze.scatteringPerM, 10.0f);
    EXPECT_THAT(errorOf("[haze]\nscattering=10.1"), HasSubstr("must be 0 to 10"));
}

TEST(Show, albedoIsTheColorOfASurface) {
    const auto albedoOf = [](const std::string& key) {
        return parse("[[object]]\ntype='box'\n" + key).objects.at(0).material.albedo;
    };
    EXPECT_EQ(albedoOf("albedo=[0.1,0.2,0.3]"), albedoOf("color=[0.1,0.2,0.3]"));
    EXPECT_NEAR(albedoOf("albedo=[0.2,0.2,0.2]").g, 0.2f, 1e-6f);
    EXPECT_THAT(errorOf("[[object]]\ntype='box'\nalbedo=[0,0,0]\ncolor=[0,0,0]"),
                StartsWith("folder/a.toml:4: [[object]] has both 'albedo' and 'color'; keep one of them"));
    EXPECT_THAT(errorOf("[[object]]\ntype='box'\nalbedo=[0,0,1.1]"), HasSubstr("'albedo' in [[object]]"));
}

TEST(Show, namesTheNearestKey) {
    const std::string error = errorOf("\n[haze]\nextinctoin = 0.02");
    EXPECT_THAT(error, StartsWith("folder/a.toml:3: unknown key 'extinctoin' in [haze]."));
    EXPECT_THAT(error, HasSubstr("Did you mean 'extinction'?"));
}

TEST(Show, namesEachKnownKeyOnce) {
    const std::string error = errorOf("[[input]]\nprotocl = \"sacn\"\n");
    EXPECT_THAT(error, HasSubstr("Did you mean 'protocol'?"));
    EXPECT_THAT(error, ::testing::Not(::testing::ContainsRegex("protocol, protocol")));
}

TEST(Show, namesFileAndLineOfBrokenToml) {
    EXPECT_THAT(errorOf("title = \"a\"\nbackground = [1, 2"), StartsWith("folder/a.toml:2: "));
}

TEST(Show, listsTheTypesOfObjects) {
    EXPECT_THAT(errorOf("[[object]]\ntype = \"teapod\""), HasSubstr("Did you mean 'teapot'?"));
}

TEST(Show, refusesNumbersOutOfRange) {
    EXPECT_THAT(errorOf("[haze]\nnoise = 1.5"), HasSubstr("'noise' in [haze] is 1.5, which must be 0 to 1"));
    EXPECT_THAT(errorOf("[haze]\nextinction = nan"), HasSubstr("must be 0 to 10"));
    EXPECT_THAT(errorOf("background = [0, 9223372036854775807, 0]"), HasSubstr("which must be 0 to 1000000"));
    EXPECT_THAT(errorOf("[exposure]\nev100 = \"8\""), HasSubstr("must be a number"));
    EXPECT_THAT(errorOf("background = [1, 2]"), HasSubstr("must be a list of three numbers"));
    EXPECT_THAT(errorOf("[[object]]\ntype = \"box\"\nsize = [1, 0, 1]"), HasSubstr("above 0 along y"));
    EXPECT_THAT(errorOf("[[object]]\ntype = \"wall\"\nshadow = 1"), HasSubstr("must be true or false"));
}

TEST(Show, refusesKeysThatNestWithoutEnd) {
    std::string deep = "a";
    for (int i = 0; i < 100'000; ++i) deep += ".'='";
    for (const std::string& text : {deep + " = 1", "[" + deep + "]", "haze = {" + deep + " = 1}"}) {
        EXPECT_THAT(errorOf("title = \"\"\"b\"\"\"\"\n" + text),
                    StartsWith("folder/a.toml:2: a key has too many dots"));
    }
}

TEST(Show, dotsInTextsAndCommentsAreNoKeys) {
    const std::string dots(100, '.');
    for (const std::string quote : {"\"", "'", "\"\"\"", "\'\'\'"}) {
        const std::string text = "title = " + quote + dots + quote + "  # " + dots + "\n# " + dots;
        EXPECT_EQ(parse(text).title, dots);
    }
}

TEST(Show, refusesAFixtureWithoutItsPatch) {
    EXPECT_THAT(errorOf("[[fixture]]\nname = \"a\""),
                StartsWith("folder/a.toml:1: [[fixture]] needs 'gdtf'"));
    EXPECT_THAT(errorOf("[[fixture]]\nname=\"a\"\ngdtf=\"b\"\nmode=\"c\"\nuniverse=40000\nslot=1"),
                HasSubstr("'universe' in [[fixture]] is 40000"));
    EXPECT_THAT(errorOf("[[fixture]]\nname=\"a\"\ngdtf=\"b\"\nmode=\"c\"\nuniverse=0\nslot=1.5"),
                HasSubstr("must be a whole number"));
}

TEST(Show, refusesTwoFixturesOfOneName) {
    const std::string fixture = "[[fixture]]\nname=\"a\"\ngdtf=\"b\"\nmode=\"c\"\nuniverse=0\nslot=1\n";
    EXPECT_THAT(errorOf(fixture + fixture), StartsWith("folder/a.toml:7: a second fixture is named 'a'"));
}

TEST(Show, refusesSingleBracketsForLists) {
    EXPECT_THAT(errorOf("[camera]\nname = \"a\""), HasSubstr("[[camera]]"));
}

TEST(Show, listsItsCameras) {
    try {
        parse(kWholeShow).camera("frond");
        FAIL();
    } catch (const ShowError& error) {
        EXPECT_THAT(error.what(), HasSubstr("Did you mean 'front'?"));
    }
}

TEST(Show, survivesEveryTruncation) {
    const std::string whole = kWholeShow;
    for (std::size_t size = 0; size < whole.size(); ++size) {
        const std::string error = errorOf(whole.substr(0, size));
        EXPECT_TRUE(error == "no error" || error.starts_with("folder/a.toml:")) << error;
    }
}

TEST(Show, survivesGarbage) {
    std::mt19937 random(1);
    std::uniform_int_distribution<int> byte(0, 255);
    for (int round = 0; round < 200; ++round) {
        std::string garbage(512, '\0');
        for (char& letter : garbage) letter = static_cast<char>(byte(random));
        EXPECT_THAT(errorOf(garbage), StartsWith("folder/a.toml:"));
    }
}

TEST(Show, missingFileIsOneSentence) {
    try {
        loadShow("/nowhere/a.toml");
        FAIL();
    } catch (const ShowError& error) {
        EXPECT_THAT(error.what(), StartsWith("/nowhere/a.toml: the show cannot be read"));
    }
}

TEST(WorldFromPlaced, turnsAboutXThenYThenZ) {
    // Local -Z: X by 90 degrees carries it to +Y, then Z by 90 degrees to -X.
    const glm::dmat4 world = worldFromPlaced({1.0, 2.0, 3.0}, {90.0, 0.0, 90.0});
    const glm::dvec3 direction = glm::dvec3(world * glm::dvec4(0.0, 0.0, -1.0, 0.0));
    EXPECT_NEAR(glm::distance(direction, glm::dvec3(-1.0, 0.0, 0.0)), 0.0, 1e-12);
    EXPECT_EQ(glm::dvec3(world[3]), glm::dvec3(1.0, 2.0, 3.0));
}

ShowFixture fixtureAt(const std::string& where) {
    return parseShow("[[fixture]]\nname='a'\ngdtf='b'\nmode='c'\nslot=1\n" + where, "a.toml").fixtures.at(0);
}

TEST(Show, patchesFixturesToArtNetSacnAndAny) {
    EXPECT_EQ(fixtureAt("universe=0").addresses.at(0).universes.at(0),
              (protocol::UniverseId{protocol::Transport::kArtNet, 0}));
    EXPECT_EQ(fixtureAt("protocol='sacn'\nuniverse=63999").addresses.at(0).universes.at(0),
              (protocol::UniverseId{protocol::Transport::kSacn, 63999}));
    EXPECT_EQ(fixtureAt("protocol='any'\nuniverse=7").addresses.at(0).universes.at(0),
              (protocol::UniverseId{protocol::Transport::kAny, 7}));
    EXPECT_THROW(fixtureAt("protocol='sacn'\nuniverse=0"), ShowError);
    EXPECT_THROW(fixtureAt("protocol='sacn'\nuniverse=64000"), ShowError);
    EXPECT_THROW(fixtureAt("protocol='artnet'\nuniverse=32768"), ShowError);
}

TEST(Show, anInputHasTheKeysOfItsProtocol) {
    const ShowInput sacn = parseShow("[[input]]\nprotocol='sacn'", "a.toml").inputs.at(0);
    EXPECT_EQ(sacn.port, 5568);
    EXPECT_EQ(sacn.interface, "");
    EXPECT_EQ(sacn.preview, protocol::PreviewRule::kBoth);
    EXPECT_THROW(parseShow("[[input]]\nprotocol='sacn'\naddress='10.0.0.1'", "a.toml"), ShowError);
    EXPECT_THROW(parseShow("[[input]]\nprotocol='artnet'\npreview='live'", "a.toml"), ShowError);
    EXPECT_THROW(parseShow("[[input]]\nprotocol='sacn'\npreview='never'", "a.toml"), ShowError);
}

}  // namespace
}  // namespace hazer::app
