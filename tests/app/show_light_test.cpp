// [[light]] of the show file: what it becomes, and what it refuses.
#include "app/show_light.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/light_color.h"

namespace hazer::app {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A light with everything that it needs but for what `rest` says.
std::string lightWith(const std::string& rest) {
    return "[[light]]\nname='key'\n" + rest + "\n";
}

const std::string kPose = "position=[1,2,6]\ndirection=[0,0,-2]\n";
const std::string kPower = "candela=5000\nhalf_angle=15\n";

Show parse(const std::string& text) {
    return parseShow(text, "folder/a.toml");
}

ShowLight light(const std::string& rest) {
    return parse(lightWith(rest)).lights.at(0);
}

/// What the program would say about this light.
std::string errorOf(const std::string& rest) {
    try {
        parse(lightWith(rest));
    } catch (const ShowError& error) {
        return error.what();
    }
    return "no error";
}

void expectNear(const glm::dvec3& got, const glm::dvec3& want) {
    EXPECT_NEAR(glm::distance(got, want), 0.0, 1e-12) << fmt::format("({}, {}, {})", got.x, got.y, got.z);
}

TEST(ShowLight, isWhatItsNumbersSay) {
    const ShowLight key = light(kPose + "candela=5000\nhalf_angle=15\nlens_radius=0.07\nshadow=false");
    EXPECT_EQ(key.name, "key");
    EXPECT_EQ(key.beam.lensPositionM, glm::dvec3(1.0, 2.0, 6.0));
    EXPECT_EQ(key.beam.worldFromBeam, glm::dmat3(1.0)) << "a light that shines down has +Y up in its picture";
    EXPECT_DOUBLE_EQ(key.beam.intensityCd, 5000.0);
    EXPECT_EQ(key.beam.fluxLm, 0.0);
    EXPECT_NEAR(key.beam.fieldAngleRad, glm::radians(30.0), 1e-15);
    EXPECT_EQ(key.beam.edge, render::BeamEdge::kFlat);
    EXPECT_EQ(key.beam.lensRadiusM, 0.07);
    EXPECT_FALSE(key.beam.castsShadow);
    EXPECT_FALSE(key.beam.showsLens);
    EXPECT_EQ(key.beam.gobo, -1);
}

TEST(ShowLight, aPointSourceThatCastsShadowsUnlessGiven) {
    const ShowLight plain = light(kPose + kPower);
    EXPECT_EQ(plain.beam.lensRadiusM, 0.0);
    EXPECT_TRUE(plain.beam.castsShadow);
    EXPECT_TRUE(plain.goboFile.empty());
    EXPECT_NEAR(glm::distance(plain.beam.color, render::Color(1.0f)), 0.0f, 1e-6f);
}

TEST(ShowLight, softHasTwoAngles) {
    const ShowLight soft = light(kPose + "lumen=800\nprofile='soft'\nhalf_angle=179\nbeam_half_angle=90");
    EXPECT_EQ(soft.beam.edge, render::BeamEdge::kSoft);
    EXPECT_NEAR(soft.beam.fieldAngleRad, glm::radians(358.0), 1e-12);
    EXPECT_NEAR(soft.beam.beamAngleRad, glm::radians(180.0), 1e-12);
    EXPECT_EQ(soft.beam.fluxLm, 800.0);
    EXPECT_EQ(soft.beam.intensityCd, 0.0);
}

TEST(ShowLight, shinesAlongItsDirectionOrAtItsTarget) {
    for (const char* way : {"direction=[0,3,0]", "target=[1,7,6]", "direction=[0,1e-5,0]"}) {
        const render::Beam beam = light(fmt::format("position=[1,2,6]\n{}\n{}", way, kPower)).beam;
        expectNear(beam.worldFromBeam * glm::dvec3(0.0, 0.0, -1.0), {0.0, 1.0, 0.0});
        expectNear(beam.worldFromBeam[0], {1.0, 0.0, 0.0});
        expectNear(beam.worldFromBeam[1], {0.0, 0.0, 1.0});
    }
}

TEST(ShowLight, theSmallestDirectionHasADirection) {
    const render::Beam beam = light("position=[0,0,0]\ndirection=[5e-324,0,0]\n" + kPower).beam;
    expectNear(-beam.worldFromBeam[2], {1.0, 0.0, 0.0});
}

TEST(ShowLight, upTurnsThePicture) {
    const render::Beam beam = light(kPose + kPower + "up=[4,0,9]").beam;
    expectNear(beam.worldFromBeam[1], {1.0, 0.0, 0.0});
    expectNear(beam.worldFromBeam[0], {0.0, -1.0, 0.0});
    EXPECT_NEAR(glm::determinant(beam.worldFromBeam), 1.0, 1e-12);
}

TEST(ShowLight, candelaStayCandelaInColour) {
    for (const char* color : {"[1,0,0]", "[0,0,0.001]", "[0.2,0.9,0.4]", "[5e-324,0,0]"}) {
        const render::Beam beam = light(kPose + kPower + "color=" + color).beam;
        EXPECT_NEAR(luminance(glm::dvec3(beam.color)), 1.0, 1e-6) << color;
    }
}

TEST(ShowLight, hasAGoboFromTheFolderOfTheShow) {
    const ShowLight spot = light(kPose + kPower + "gobo='gobos/f.png'\ngobo_rotation=90\nfocus=7.5");
    EXPECT_EQ(spot.goboFile, "folder/gobos/f.png");
    EXPECT_NEAR(spot.beam.goboRotationRad, glm::radians(90.0), 1e-15);
    EXPECT_EQ(spot.beam.focusDistanceM, 7.5);
}

TEST(ShowLight, hasAWebThatSaysItsBeam) {
    const ShowLight measured = light(kPose + "profile='web'\nweb='ies/par.ies'");
    EXPECT_EQ(measured.webFile, "folder/ies/par.ies");
    EXPECT_EQ(measured.beam.intensityCd, 0.0);
    EXPECT_EQ(measured.beam.fluxLm, 0.0);
    EXPECT_EQ(light(kPose + "profile='web'\nweb='a.ies'\nlumen=70").beam.fluxLm, 70.0);
    EXPECT_THAT(errorOf(kPose + "profile='web'"), HasSubstr("needs 'web'"));
    EXPECT_THAT(errorOf(kPose + "profile='web'\nweb=''"), HasSubstr("'web' in [[light]] must not be empty"));
    EXPECT_THAT(errorOf(kPose + kPower + "web='a.ies'"), HasSubstr("needs profile = \"web\""));
    EXPECT_THAT(errorOf(kPose + "profile='web'\nweb='a.ies'\nhalf_angle=9"),
                HasSubstr("'half_angle' in [[light]] is what the 'web' says; leave it out"));
    EXPECT_THAT(errorOf(kPose + "profile='web'\nweb='a.ies'\ncandela=1\nlumen=1"), HasSubstr("keep one"));
}

TEST(ShowLight, namesWhatIsMissing) {
    EXPECT_THAT(errorOf(""), StartsWith("folder/a.toml:1: [[light]] needs 'position'"));
    EXPECT_THAT(errorOf("position=[0,0,1]"), HasSubstr("needs 'direction' or 'target'"));
    EXPECT_THAT(errorOf(kPose), HasSubstr("needs 'candela' or 'lumen'"));
    EXPECT_THAT(errorOf(kPose + "candela=1"), HasSubstr("needs 'half_angle'"));
    EXPECT_THAT(errorOf(kPose + kPower + "profile='soft'"), HasSubstr("needs 'beam_half_angle'"));
    try {
        parse("\n[[light]]\nposition=[0,0,1]");
        FAIL();
    } catch (const ShowError& error) {
        EXPECT_THAT(error.what(), StartsWith("folder/a.toml:2: [[light]] needs 'name'"));
    }
}

TEST(ShowLight, refusesWhatIsSaidTwice) {
    EXPECT_THAT(errorOf(kPose + "target=[0,0,0]\n" + kPower),
                StartsWith("folder/a.toml:5: [[light]] has both 'direction' and 'target'; keep one"));
    EXPECT_THAT(errorOf(kPose + kPower + "lumen=3"),
                StartsWith("folder/a.toml:7: [[light]] has both 'candela' and 'lumen'; keep one"));
    EXPECT_THAT(errorOf(kPose + kPower + "beam_half_angle=3"), HasSubstr("needs profile = \"soft\""));
}

TEST(ShowLight, refusesNumbersOutOfRange) {
    EXPECT_THAT(errorOf("position=[0,nan,0]\ndirection=[0,0,-1]\n" + kPower),
                StartsWith("folder/a.toml:3: 'position' in [[light]] is nan"));
    for (const char* candela : {"nan", "inf", "-1", "0", "1e-4", "1e10"}) {
        EXPECT_THAT(errorOf(kPose + "half_angle=9\ncandela=" + candela),
                    StartsWith("folder/a.toml:6: 'candela' in [[light]] is"));
    }
    for (const char* angle : {"nan", "0", "0.001", "180", "-4", "inf"}) {
        EXPECT_THAT(errorOf(kPose + "candela=9\nhalf_angle=" + angle), HasSubstr("must be 0.005 to 179"));
    }
    EXPECT_THAT(errorOf(kPose + kPower + "profile='soft'\nbeam_half_angle=15.1"),
                HasSubstr("which must be 0.005 to 15"));
    EXPECT_THAT(errorOf(kPose + kPower + "lens_radius=-0.1"), HasSubstr("must be 0 to 10"));
    EXPECT_THAT(errorOf(kPose + kPower + "lens_radius=1e300"), HasSubstr("must be 0 to 10"));
    EXPECT_THAT(errorOf(kPose + kPower + "color=[1,2,1]"), HasSubstr("must be 0 to 1"));
    EXPECT_THAT(errorOf(kPose + kPower + "gobo='a.png'\nfocus=-1"), HasSubstr("'focus' in [[light]] is -1"));
}

TEST(ShowLight, refusesDirectionsThatAreNone) {
    EXPECT_THAT(errorOf("position=[0,0,1]\ndirection=[0,0,0]\n" + kPower),
                HasSubstr("must not be [0, 0, 0]"));
    EXPECT_THAT(errorOf("position=[0,0,1]\ndirection=[0,nan,0]\n" + kPower), HasSubstr("is nan"));
    EXPECT_THAT(errorOf("position=[0,0,1]\ntarget=[0,0,1]\n" + kPower), HasSubstr("move one of them"));
    EXPECT_THAT(errorOf(kPose + kPower + "up=[0,0,5]"),
                HasSubstr("must not lie along the light's direction"));
    EXPECT_THAT(errorOf(kPose + kPower + "up=[0,0,0]"), HasSubstr("'up' in [[light]] must not be"));
}

TEST(ShowLight, refusesWhatWouldDoNothing) {
    EXPECT_THAT(errorOf(kPose + kPower + "color=[0,0,0]"), HasSubstr("left out of the show"));
    EXPECT_THAT(errorOf(kPose + kPower + "focus=3"), HasSubstr("'focus' in [[light]] needs a 'gobo'"));
    EXPECT_THAT(errorOf(kPose + "candela=1\nhalf_angle=90\ngobo='a.png'"), HasSubstr("at most 89"));
    EXPECT_THAT(errorOf(kPose + kPower + "candella=3"), HasSubstr("Did you mean 'candela'?"));
    EXPECT_THAT(errorOf(kPose + kPower + "profile='hard'"), HasSubstr("unknown profile 'hard'"));
}

TEST(ShowLight, sharesItsNamesWithFixtures) {
    const std::string one = lightWith(kPose + kPower);
    EXPECT_THROW(parse(one + one), ShowError);
    try {
        parse("[[fixture]]\nname='key'\ngdtf='b'\nmode='c'\nuniverse=0\nslot=1\n" + one);
        FAIL();
    } catch (const ShowError& error) {
        EXPECT_THAT(error.what(), StartsWith("folder/a.toml:7: a second fixture or light is named 'key'"));
    }
}

}  // namespace
}  // namespace hazer::app
