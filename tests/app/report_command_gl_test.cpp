// hazer report drawing: what it prints and what it writes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/paths.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace hazer::app {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string kOneSpot = (showFolder() / "one-spot.toml").string();

test::ProcessResult report(std::vector<std::string> arguments,
                           const std::map<std::string, std::string>& environment = {}) {
    arguments.insert(arguments.begin(), "report");
    return test::runProcess(HAZER_PROGRAM, arguments, environment);
}

std::string textOf(const std::filesystem::path& file) {
    std::ifstream stream(file);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

TEST(ReportSpeedGl, timesEachPass) {
    const test::TemporaryFolder folder;
    const std::string out = (folder.path() / "new/folder").string();
    const test::ProcessResult result =
        report({"speed", kOneSpot, "--size", "32x18", "--frames", "3", "--json", "--out", out});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    const auto json = nlohmann::json::parse(result.output);
    EXPECT_EQ(json["show"], "one-spot.toml");
    EXPECT_EQ(json["size"], nlohmann::json({32, 18}));
    EXPECT_EQ(json["frames"], 3);
    EXPECT_GT(json["fps"].get<double>(), 0.0);
    EXPECT_NEAR(json["fps"].get<double>() * json["frame_ms_median"].get<double>(), 1000.0, 1e-6);
    ASSERT_FALSE(json["passes"].empty());
    for (const auto& pass : json["passes"]) EXPECT_GE(pass["ms_median"].get<double>(), 0.0);
    EXPECT_EQ(textOf(std::filesystem::path(out) / "speed.json"), result.output);
    EXPECT_THAT(textOf(std::filesystem::path(out) / "speed.md"), StartsWith("# Speed of one-spot.toml\n"));
}

TEST(ReportSpeedGl, aFolderThatCannotBeMade) {
    const test::ProcessResult result =
        report({"speed", kOneSpot, "--size", "16x9", "--frames", "1", "--out", "/proc/nowhere"});
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_THAT(result.errors, HasSubstr("/proc/nowhere"));
}

TEST(ReportSpeedGl, withoutOpenGl41) {
    EXPECT_EQ(report({"speed", kOneSpot}, {{"MESA_GL_VERSION_OVERRIDE", "3.3"}}).exitCode, 3);
}

}  // namespace
}  // namespace hazer::app
