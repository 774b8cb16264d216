// hazer report as a person runs it: help, mistakes, and nothing of OpenGL.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/process.h"

namespace hazer::app {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

test::ProcessResult report(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "report");
    return test::runProcess(HAZER_PROGRAM, arguments);
}

TEST(Report, helpBeginsWithExamples) {
    EXPECT_THAT(report({"--help"}).output, StartsWith("Examples:\n  hazer report "));
    for (const std::string part : {"accuracy", "speed"}) {
        const test::ProcessResult result = report({part, "--help"});
        EXPECT_EQ(result.exitCode, 0);
        EXPECT_THAT(result.output, StartsWith("Examples:\n  hazer report " + part));
    }
}

TEST(Report, aloneItShowsItsHelp) {
    const test::ProcessResult alone = report({});
    EXPECT_EQ(alone.exitCode, 1);
    EXPECT_EQ(alone.output, "");
    EXPECT_THAT(alone.errors, StartsWith("Examples:\n  hazer report "));
    EXPECT_THAT(alone.errors, HasSubstr("Usage: hazer report"));
}

TEST(Report, namesAMistypedReport) {
    const test::ProcessResult result = report({"sped"});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_THAT(result.errors, HasSubstr("sped"));
}

TEST(ReportSpeed, hostileOptions) {
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"--frames", "0"},
                                                      {"--frames", "nan"},
                                                      {"--frames", "99999999999999999999"},
                                                      {"--size", "0x0"},
                                                      {"--size", "x"},
                                                      {"--size", "8193x1"},
                                                      {"--size", "-1x10"},
                                                      {"--integrator", "magic"},
                                                      {"a.toml", "b.toml"}}) {
        std::vector<std::string> all = arguments;
        all.insert(all.begin(), "speed");
        const test::ProcessResult result = report(all);
        EXPECT_EQ(result.exitCode, 1) << arguments.front() << ' ' << arguments.back();
        EXPECT_EQ(result.output, "");
        EXPECT_NE(result.errors, "");
    }
}

TEST(ReportAccuracy, hostileOptions) {
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"--scene", "moon"},
                                                      {"--scene", "plain", "a.toml"},
                                                      {"--scene"},
                                                      {"--size", "0x10"},
                                                      {"--size", "1e9x1"},
                                                      {"--set", "spot1"},
                                                      {"--quick=maybe"},
                                                      {"--out"},
                                                      {"a.toml", "b.toml"}}) {
        std::vector<std::string> all = arguments;
        all.insert(all.begin(), "accuracy");
        const test::ProcessResult result = report(all);
        EXPECT_EQ(result.exitCode, 1) << arguments.front() << ' ' << arguments.back();
        EXPECT_EQ(result.output, "");
        EXPECT_NE(result.errors, "");
    }
}

// What the report draws can be drawn alone, too.
TEST(Render, takesAsManySamplesAsTheReport) {
    const auto render = [](const char* samples) {
        return test::runProcess(HAZER_PROGRAM, {"render", "/nowhere/a.toml", "--samples", samples}).exitCode;
    };
    EXPECT_EQ(render("16384"), 2) << "the show is missing, not the samples wrong";
    EXPECT_EQ(render("16385"), 1);
    EXPECT_EQ(render("0"), 1);
}

TEST(ReportAccuracy, aMissingShow) {
    const test::ProcessResult result = report({"accuracy", "/nowhere/a.toml"});
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_THAT(result.errors, HasSubstr("/nowhere/a.toml"));
}

TEST(ReportSpeed, aMissingShow) {
    const test::ProcessResult result = report({"speed", "/nowhere/a.toml"});
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_THAT(result.errors, HasSubstr("/nowhere/a.toml"));
}

}  // namespace
}  // namespace hazer::app
