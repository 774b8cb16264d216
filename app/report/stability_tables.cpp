#include "app/report/stability_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace hazer::app {
namespace {

using nlohmann::ordered_json;

template <typename Rows>
bool allPassed(const Rows& rows) {
    return std::all_of(rows.begin(), rows.end(), [](const auto& row) { return row.passed(); });
}

ordered_json lightJson(const StabilityRow& row) {
    return {{"name", row.name},
            {"rays", row.rays},
            {"not_finite", row.notFinite},
            {"below_zero", row.belowZero},
            {"compared", row.compared},
            {"median_error", row.medianError},
            {"p99_error", row.p99Error},
            {"worst_error", row.worstError},
            {"verdict", row.verdict}};
}

std::string lightLine(const StabilityRow& row) {
    const std::string errors = row.compared == 0 ? std::string("| | | ")
                                                 : fmt::format("| {:.1e} | {:.1e} | {:.1e} ", row.medianError,
                                                               row.p99Error, row.worstError);
    return fmt::format("| {} | {} | {} | {} | {} {}| {} |\n", row.name, row.rays, row.notFinite,
                       row.belowZero, row.compared, errors, row.verdict);
}

constexpr const char* kLightHead =
    "| case | rays | NaN, Inf | below 0 | compared | median | 99 % | worst | verdict |\n"
    "|---|---|---|---|---|---|---|---|---|\n";

}  // namespace

bool StabilityReport::passed() const {
    return allPassed(light) && allPassed(refusals) && random.passed() && allPassed(motion);
}

ordered_json stabilityJson(const StabilityReport& report) {
    ordered_json json{{"device", report.device}, {"passed", report.passed()}};
    json["light"] = ordered_json::array();
    for (const StabilityRow& row : report.light) json["light"].push_back(lightJson(row));
    json["refusals"] = ordered_json::array();
    for (const StabilityRow& row : report.refusals) {
        json["refusals"].push_back({{"name", row.name}, {"verdict", row.verdict}});
    }
    json["random"] = lightJson(report.random);
    json["random"]["worst_ray"] = report.worstRay;
    json["motion"] = ordered_json::array();
    for (const MotionRow& row : report.motion) {
        json["motion"].push_back({{"name", row.name},
                                  {"steps", row.steps},
                                  {"worst_deviation", row.worstDeviation},
                                  {"verdict", row.verdict}});
    }
    return json;
}

std::string stabilityMarkdown(const StabilityReport& report) {
    std::string text = fmt::format("# Stability\n\n{}. Everything {}.\n\n", report.device,
                                   report.passed() ? "passed" : "did not pass: see the verdicts");
    text += fmt::format(
        "Every ray is drawn by the shaders in float. Where a single ray stands for a pixel it is held "
        "against the "
        "oracle\n(adaptive quadrature in double); errors are relative to the light there, or to a thousandth "
        "of the "
        "brightest. Allowed:\n{:g} at the median, {:g} at 99 % of the rays.\n\n## Light\n\n",
        kStabilityMedianError, kStabilityP99Error);
    text += kLightHead;
    for (const StabilityRow& row : report.light) text += lightLine(row);
    text += lightLine(report.random);
    if (!report.worstRay.empty()) text += fmt::format("\nWorst random ray: {}.\n", report.worstRay);
    text += "\n## What is refused\n\n| input | verdict |\n|---|---|\n";
    for (const StabilityRow& row : report.refusals)
        text += fmt::format("| {} | {} |\n", row.name, row.verdict);
    text += "\n## Motion\n\n| case | steps | worst deviation | verdict |\n|---|---|---|---|\n";
    for (const MotionRow& row : report.motion) {
        text +=
            fmt::format("| {} | {} | {:.1e} | {} |\n", row.name, row.steps, row.worstDeviation, row.verdict);
    }
    return text;
}

}  // namespace hazer::app
