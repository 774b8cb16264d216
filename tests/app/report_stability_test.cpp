// The stability report's cases and judgements, without drawing.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "app/report/stability_cases.h"
#include "app/report/stability_run.h"
#include "app/report/stability_tables.h"
#include "app/show.h"

namespace hazer::test {
namespace {

TEST(StabilityCases, AreAtLeastFortyAndNamedOnce) {
    std::set<std::string> names;
    for (const auto& one : app::stabilityCases()) EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_GE(names.size(), 40u);
}

// A show that is refused for anything but the number in question would prove nothing.
TEST(StabilityCases, RefusedShowsAreRefusedForTheirNumber) {
    for (const auto& show : app::refusedShows()) {
        const std::string key = show.name.substr(0, show.name.find(' '));
        try {
            app::parseShow(show.text, "a.toml");
            ADD_FAILURE() << show.name << " is taken";
        } catch (const app::ShowError& error) {
            const std::string what = error.what();
            EXPECT_TRUE(what.find(key) != std::string::npos || key == "phase") << what;
        }
    }
}

TEST(StabilityRun, CountsWhatIsNoNumberAndWhatIsBelowZero) {
    const float inf = std::numeric_limits<float>::infinity();
    const render::FloatImage picture{2, 2, {0, 0, 0, 1, NAN, 1, -1, 0, 0, 1, 1, inf}};
    const app::StabilityRow row = app::countFaults("a", picture);
    EXPECT_EQ(row.rays, 4u);
    EXPECT_EQ(row.notFinite, 2u);
    EXPECT_EQ(row.belowZero, 1u);
    EXPECT_FALSE(row.passed());
    EXPECT_TRUE(app::countFaults("b", {1, 1, {0, 1, 2}}).passed());
}

TEST(StabilityRun, ErrorsAreSummedUpByRank) {
    app::StabilityRow row;
    std::vector<double> errors;
    for (int i = 100; i >= 0; --i) errors.push_back(i);
    app::addErrors(errors, row);
    EXPECT_EQ(row.compared, 101u);
    EXPECT_EQ(row.medianError, 50.0);
    EXPECT_EQ(row.p99Error, 99.0);
    EXPECT_EQ(row.worstError, 100.0);
}

TEST(StabilityTables, SayWhatFailed) {
    app::StabilityReport report;
    report.random.verdict = "ok";
    report.light.push_back(app::countFaults("a hole", {1, 1, {NAN, 0, 0}}));
    EXPECT_FALSE(report.passed());
    const auto json = app::stabilityJson(report);
    EXPECT_FALSE(json.at("passed").get<bool>());
    EXPECT_EQ(json.at("light").at(0).at("not_finite"), 1);
    EXPECT_NE(app::stabilityMarkdown(report).find("| a hole | 1 | 1 |"), std::string::npos);
}

}  // namespace
}  // namespace hazer::test
