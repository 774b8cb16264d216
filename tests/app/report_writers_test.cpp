// What the accuracy report writes, from figures that are known.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <sstream>

#include "app/report/accuracy_files.h"
#include "app/report/accuracy_markdown.h"
#include "app/report/accuracy_tables.h"
#include "app/report/error_plot.h"
#include "app/report/integrator_settings.h"
#include "tests/support/temporary_folder.h"

namespace hazer::app {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

AccuracyRow row(const std::string& integrator, const std::string& setting, int samples, double ms,
                double rms) {
    AccuracyRow row;
    row.integrator = integrator;
    row.setting = setting;
    row.samples = samples;
    row.frames = 7;
    row.msMedian = ms;
    row.frameMsMedian = ms + 20.0;
    row.error = {1000, rms, 2.0 * rms, 3.0 * rms, 0.0};
    return row;
}

/// Uniform falls as one over the samples; angle is as good as uniform with 1000.
AccuracyReport example() {
    AccuracyReport report{"a \"device\"", 64, 48, {}};
    AccuracyScene scene;
    scene.name = "plain";
    scene.title = "Plain <beam> & \"more\"";
    for (const int samples : {20, 110, 440, 4096}) {
        scene.rows.push_back(
            row(kUniformName, samplesSetting(samples), samples, 0.1 * samples, 10.0 / samples));
    }
    scene.rows.push_back(row(kAngleName, kOwnSetting, 0, 0.5, 0.01));
    scene.oracle = OracleCheck{200, 3, 1e-4, 5e-4};
    scene.notes = {"Something was left out, since it would take long."};
    report.scenes.push_back(scene);
    return report;
}

TEST(EqualErrorOf, comparesAtTheSameError) {
    const auto equal = equalError(example().scenes.front());
    ASSERT_TRUE(equal.has_value());
    EXPECT_TRUE(equal->uniform.isReached);
    EXPECT_NEAR(equal->uniform.ms, 100.0, 1e-6);
    EXPECT_NEAR(equal->timesFaster, 200.0, 1e-6);
}

TEST(EqualErrorOf, needsBothIntegrators) {
    AccuracyScene scene = example().scenes.front();
    scene.rows.pop_back();
    EXPECT_FALSE(equalError(scene).has_value());
    EXPECT_FALSE(equalError(AccuracyScene{}).has_value());
}

TEST(AccuracyJson, hasWhatMachinesExpect) {
    const auto json = accuracyJson(example());
    EXPECT_EQ(json["device"], "a \"device\"");
    EXPECT_EQ(json["size"], nlohmann::ordered_json({64, 48}));
    ASSERT_EQ(json["rows"].size(), 5u);
    for (const auto& found : json["rows"]) {
        EXPECT_EQ(found["scene"], "plain");
        EXPECT_TRUE(found["integrator"].is_string() && found["setting"].is_string());
        EXPECT_TRUE(found["samples"].is_number_integer());
        for (const char* key : {"ms_median", "rms_rel", "p99_rel", "max_rel"}) {
            EXPECT_TRUE(found[key].is_number()) << key;
        }
    }
    EXPECT_EQ(json["rows"][1]["samples"], 110);
    EXPECT_EQ(json["oracle"][0]["pixels"], 200);
    EXPECT_EQ(json["oracle"][0]["light"], "air");
    EXPECT_EQ(json["equal_error"][0]["uniform_reaches_it"], true);
    EXPECT_EQ(json["notes"][0]["scene"], "plain");
}

TEST(AccuracyJson, anErrorThatIsNoNumberIsNull) {
    AccuracyReport report = example();
    report.scenes[0].rows[0].error.rmsRel = std::numeric_limits<double>::infinity();
    const std::string text = accuracyJson(report).dump();
    EXPECT_TRUE(nlohmann::json::parse(text)["rows"][0]["rms_rel"].is_null());
}

TEST(AccuracyCsv, aLineARow) {
    AccuracyReport report = example();
    report.scenes[0].name = "mine, \"too\"";
    std::istringstream lines(accuracyCsv(report));
    std::string line;
    std::getline(lines, line);
    EXPECT_THAT(line,
                ::testing::StartsWith("scene,integrator,setting,samples,ms_median,rms_rel,p99_rel,max_rel"));
    std::getline(lines, line);
    EXPECT_EQ(line, "\"mine, \"\"too\"\"\",uniform,20 samples,20,2,0.5,1,1.5,0,22,7,1000");
    int rest = 0;
    while (std::getline(lines, line)) ++rest;
    EXPECT_EQ(rest, 4);
}

TEST(AccuracyMarkdown, saysHowMuchFasterAtEqualError) {
    const std::string text = accuracyMarkdown(example());
    EXPECT_THAT(text, HasSubstr("64 x 48 pixels"));
    EXPECT_THAT(text, HasSubstr("| 100.0 ms | 200 |"));
    EXPECT_THAT(text, HasSubstr("(accuracy-plain.svg)"));
    EXPECT_THAT(text,
                HasSubstr("in the air differs from the oracle by 0.01 % (rms) over 200 lit pixels, 0.05 "
                          "% at the worst; 3 more, on outlines of bodies, were left out."));
    EXPECT_THAT(text, HasSubstr("would take long."));
}

TEST(AccuracyMarkdown, saysWhereUniformDoesNotReach) {
    AccuracyReport report = example();
    report.scenes[0].rows.back().error.rmsRel = 1e-4;
    const std::string text = accuracyMarkdown(report);
    EXPECT_THAT(text, HasSubstr("not reached: 0.24 % after 410 ms"));
    EXPECT_THAT(text, HasSubstr("more than 819"));
}

TEST(AccuracyMarkdown, hasTheThesisTable) {
    const std::string text = accuracyMarkdown(example());
    const std::string table = text.substr(text.find("## The thesis' table"));
    EXPECT_THAT(table, HasSubstr("| uniform, 20 samples | 45.5 | 500.0 | 50 % |"));
    EXPECT_THAT(table, Not(HasSubstr("110 samples | 3")));
    EXPECT_THAT(table, HasSubstr("| angle, default |"));
}

TEST(AccuracyMarkdown, ofNothing) {
    EXPECT_THAT(accuracyMarkdown({"device", 1, 1, {}}), HasSubstr("device"));
}

/// Numbers in the attributes of every element of a well-formed document.
void expectWellFormed(const std::string& svg) {
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(svg.c_str())) << svg;
    EXPECT_STREQ(document.document_element().name(), "svg");
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("inf")));
}

TEST(ErrorPlot, isWellFormedWhateverTheText) {
    const std::string svg = accuracyPlot(example().scenes.front());
    expectWellFormed(svg);
    EXPECT_THAT(svg, HasSubstr("Plain &lt;beam> &amp; &quot;more&quot;"));
    EXPECT_THAT(svg, HasSubstr("prefers-color-scheme:dark"));
    expectWellFormed(errorPlot("\x01\x1f", {}));
}

TEST(ErrorPlot, namesEachLineBesideIt) {
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(accuracyPlot(example().scenes.front()).c_str()));
    std::vector<std::string> names;
    for (const pugi::xml_node& text : document.document_element().children("text")) {
        if (std::string(text.attribute("class").value()).find("name ") == 0) {
            names.emplace_back(text.text().get());
        }
    }
    EXPECT_THAT(names, ::testing::UnorderedElementsAre("uniform", "angle"));
}

TEST(ErrorPlot, aTenthOfTheErrorIsADecadeDown) {
    const std::string svg = errorPlot("", {{"a", {{1.0, 1.0, ""}, {10.0, 0.1, ""}, {100.0, 0.01, ""}}}});
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(svg.c_str()));
    std::vector<double> x, y;
    for (const pugi::xml_node& dot : document.document_element().children("circle")) {
        x.push_back(dot.attribute("cx").as_double());
        y.push_back(dot.attribute("cy").as_double());
    }
    ASSERT_EQ(x.size(), 3u);
    EXPECT_NEAR(x[1] - x[0], x[2] - x[1], 0.11);
    EXPECT_NEAR(y[1] - y[0], y[2] - y[1], 0.11);
    EXPECT_GT(y[1], y[0]) << "less error lies lower";
}

TEST(ErrorPlot, whatCannotBeDrawnIsLeftOut) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    expectWellFormed(
        errorPlot("", {{"a", {{nan, 1.0, ""}, {1.0, nan, ""}, {0.0, 1.0, ""}, {1.0, infinity, ""}}}}));
    expectWellFormed(errorPlot("", {{"a", {{1.0, 0.0, "none"}}}}));
    expectWellFormed(errorPlot("", {{"a", {{1e-300, 1e300, "far"}, {1e300, 1e-300, "away"}}}}));
}

TEST(AccuracyFiles, standInTheFolder) {
    const test::TemporaryFolder folder;
    const std::filesystem::path out = folder.path() / "a/b";
    writeAccuracyReport(example(), out);
    writeAccuracyReport(example(), out);  // over older ones
    for (const char* name : {"accuracy.json", "accuracy.csv", "accuracy.md", "accuracy-plain.svg"}) {
        EXPECT_GT(std::filesystem::file_size(out / name), 100u) << name;
    }
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(out), {}), 4);
    EXPECT_THROW(writeAccuracyReport(example(), "/proc/nowhere"), std::runtime_error);
}

}  // namespace
}  // namespace hazer::app
