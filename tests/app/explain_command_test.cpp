// hazer explain: the real program, which needs no OpenGL for it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/paths.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace hazer::app {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const std::string kOneSpot = (showFolder() / "one-spot.toml").string();
const std::string kThesis = (showFolder() / "thesis.toml").string();

/// Where no OpenGL can be had.
test::ProcessResult explain(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "explain");
    return test::runProcess(HAZER_PROGRAM, arguments, {{"MESA_GL_VERSION_OVERRIDE", "2.1"}});
}

json explainAsJson(std::vector<std::string> arguments) {
    arguments.emplace_back("--json");
    const test::ProcessResult result = explain(arguments);
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    return json::parse(result.output);
}

json partOf(const json& explanation, const std::string& name) {
    const auto& parts = explanation["parts"];
    const auto found =
        std::find_if(parts.begin(), parts.end(), [&](const json& part) { return part["name"] == name; });
    EXPECT_NE(found, parts.end()) << name;
    return found == parts.end() ? json{} : *found;
}

TEST(Explain, SaysWhatIsNeededAndWhatIsNot) {
    const test::ProcessResult result = explain({kThesis});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_EQ(result.errors, "");
    EXPECT_THAT(result.output,
                StartsWith("A teapot in the light, camera 'front', 1280x720: 1 of 1 lamps lit"));
    const std::size_t leftOut = result.output.find("\nLeft out\n");
    ASSERT_NE(leftOut, std::string::npos);
    EXPECT_THAT(result.output.substr(0, leftOut), HasSubstr("noise is 0.7"));
    EXPECT_THAT(result.output.substr(leftOut),
                AllOf(HasSubstr("no lit lamp has a photometric web"), Not(HasSubstr("noise is"))));
}

TEST(Explain, TakesTheIntegratorAndTheBloomThatRenderTakes) {
    const auto airFeatures = [](const json& explanation) {
        std::string all;
        for (const json& variant : explanation["variants"]) all += variant["shader"].get<std::string>() + " ";
        return all;
    };
    const json asItIs = explainAsJson({kThesis});
    EXPECT_THAT(airFeatures(asItIs), Not(HasSubstr("UNIFORM")));
    EXPECT_EQ(partOf(asItIs, "bloom")["needed"], true);
    const json other = explainAsJson({kThesis, "--integrator", "uniform", "--no-bloom"});
    EXPECT_THAT(airFeatures(other), HasSubstr("UNIFORM"));
    EXPECT_EQ(partOf(other, "bloom")["needed"], false);
    EXPECT_EQ(explain({kThesis, "--integrator", "best"}).exitCode, 1);
}

TEST(Explain, AShowWithoutADeskIsDark) {
    const json dark = explainAsJson({kOneSpot});
    EXPECT_EQ(dark["lamps"]["lit"], 0);
    EXPECT_EQ(dark["lamps"]["dark"], 1);
    EXPECT_EQ(partOf(dark, "light in the air")["reason"], "no lamp is lit");
    EXPECT_EQ(partOf(dark, "dark lamps")["reason"], "1 of 1 lamps is dark");
    const json lit = explainAsJson({kOneSpot, "--set", "spot1.Dimmer=1"});
    EXPECT_EQ(lit["lamps"]["lit"], 1);
    EXPECT_TRUE(partOf(lit, "light in the air")["needed"]);
    EXPECT_GT(lit["passes"].size(), dark["passes"].size());
}

TEST(Explain, CountsTheBytesOfThePicture) {
    const json small = explainAsJson({kOneSpot, "--size", "100x50"});
    EXPECT_EQ(small["size"], json({100, 50}));
    const json picture = partOf(small, "picture");
    const auto& textures = picture["textures"];
    const auto radiance = std::find_if(textures.begin(), textures.end(),
                                       [](const json& use) { return use["name"] == "radiance"; });
    ASSERT_NE(radiance, textures.end());
    EXPECT_EQ((*radiance)["bytes"], 100 * 50 * 16);
    EXPECT_EQ((*radiance)["size"], json({100, 50, 1}));
    std::size_t sum = 0;
    for (const json& part : small["parts"]) {
        if (!part["needed"]) continue;
        for (const json& use : part["textures"]) sum += use["bytes"].get<std::size_t>();
    }
    EXPECT_EQ(small["texture_bytes"], sum);
}

TEST(Explain, NamesTheLampsOfShadowMaps) {
    const json thesis = explainAsJson({kThesis});
    ASSERT_EQ(thesis["shadow_maps"].size(), 1u);
    EXPECT_EQ(thesis["shadow_maps"][0]["lamp"], "spot1");
    EXPECT_GE(thesis["shadow_maps"][0]["casters"], 1);
    ASSERT_GE(thesis["variants"].size(), 3u);
    EXPECT_EQ(thesis["variants"][0]["beams"], 1);
}

TEST(Explain, TheCameraIsOneOfTheShow) {
    EXPECT_EQ(explainAsJson({kThesis, "--camera", "under the lamp"})["camera"], "under the lamp");
    const test::ProcessResult result = explain({kThesis, "--camera", "moon"});
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_THAT(result.errors, HasSubstr("no camera is named 'moon'"));
}

TEST(Explain, MistakesAreOneSentence) {
    EXPECT_EQ(explain({}).exitCode, 1);
    EXPECT_EQ(explain({kOneSpot, "--set", "spot1"}).exitCode, 1);
    EXPECT_EQ(explain({kOneSpot, "--size", "0x0"}).exitCode, 1);
    const test::ProcessResult missing = explain({"/nowhere/a.toml"});
    EXPECT_EQ(missing.exitCode, 2);
    EXPECT_THAT(missing.errors, AllOf(StartsWith("hazer: "), HasSubstr("/nowhere/a.toml")));
    const test::ProcessResult fixture = explain({kOneSpot, "--set", "spot2.Dimmer=1"});
    EXPECT_EQ(fixture.exitCode, 2);
    EXPECT_THAT(fixture.errors, HasSubstr("Did you mean 'spot1'?"));
}

TEST(Explain, AnEmptyShowHasAPictureAllTheSame) {
    const test::TemporaryFolder folder;
    const json empty = explainAsJson({folder.write("a.toml", "").string()});
    for (const json& part : empty["parts"]) {
        const bool isAlwaysThere =
            part["name"] == "picture" || part["name"] == "bare background" || part["name"] == "bloom";
        EXPECT_EQ(part["needed"], isAlwaysThere) << part["name"];
    }
}

}  // namespace
}  // namespace hazer::app
