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

/// The rows of one integrator, in their order.
std::vector<nlohmann::json> rowsOf(const nlohmann::json& report, const std::string& integrator) {
    std::vector<nlohmann::json> rows;
    for (const auto& row : report["rows"]) {
        if (row["integrator"] == integrator) rows.push_back(row);
    }
    return rows;
}

TEST(ReportAccuracyGl, comparesIntegratorsOnASmallPicture) {
    const test::TemporaryFolder folder;
    const std::string out = (folder.path() / "report").string();
    const test::ProcessResult result = report({"accuracy", "--quick", "--scene", "plain", "--scene", "shadow",
                                               "--size", "32x32", "--json", "--out", out});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    const auto json = nlohmann::json::parse(result.output);
    EXPECT_TRUE(json["device"].is_string());
    EXPECT_EQ(json["size"], nlohmann::json({32, 32}));
    std::vector<std::string> keys;
    for (const auto& [key, value] : json["rows"][0].items()) keys.push_back(key);
    EXPECT_THAT(keys, ::testing::IsSupersetOf({"scene", "integrator", "setting", "samples", "ms_median",
                                               "rms_rel", "p99_rel", "max_rel"}));
    for (const auto& row : json["rows"]) {
        EXPECT_GT(row["ms_median"].get<double>(), 0.0);
        EXPECT_GE(row["frame_ms_median"].get<double>(), row["ms_median"].get<double>());
        EXPECT_LE(row["rms_rel"].get<double>(), row["max_rel"].get<double>());
        EXPECT_LE(row["p99_rel"].get<double>(), row["max_rel"].get<double>());
    }
    const auto uniform = rowsOf(json, "uniform");
    const auto angle = rowsOf(json, "angle");
    ASSERT_GT(uniform.size(), 5u);
    ASSERT_GT(angle.size(), 1u);
    EXPECT_LT(angle.front()["rms_rel"].get<double>(), 0.01);
    EXPECT_GT(uniform.front()["rms_rel"].get<double>(), 0.1) << "20 samples over 12 m";
    for (const auto& check : json["oracle"]) EXPECT_LT(check["rms_rel"].get<double>(), 0.02) << check;
    for (const char* name :
         {"accuracy.json", "accuracy.csv", "accuracy.md", "accuracy-plain.svg", "accuracy-shadow.svg"}) {
        EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(out) / name)) << name;
    }
    EXPECT_EQ(textOf(std::filesystem::path(out) / "accuracy.json"), result.output);
}

TEST(ReportAccuracyGl, measuresYourOwnShow) {
    const test::TemporaryFolder folder;
    const std::string out = folder.path().string();
    const test::ProcessResult result =
        report({"accuracy", kOneSpot, "--quick", "--size", "16x16", "--set", "spot1.Dimmer=1", "--out", out});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_EQ(result.output, out + "/accuracy.md\n");
    EXPECT_THAT(textOf(out + "/accuracy.md"), HasSubstr("one-spot"));
}

TEST(ReportAccuracyGl, aDarkShowIsSaidToBeDark) {
    const test::TemporaryFolder folder;
    const test::ProcessResult result =
        report({"accuracy", kOneSpot, "--quick", "--size", "16x16", "--out", folder.path().string()});
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_THAT(result.errors, HasSubstr("no light is in the air"));
    EXPECT_THAT(result.errors, HasSubstr("--set"));
}

TEST(ReportAccuracyGl, anUnknownCamera) {
    const test::ProcessResult result = report({"accuracy", kOneSpot, "--camera", "moon"});
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_THAT(result.errors, HasSubstr("moon"));
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
