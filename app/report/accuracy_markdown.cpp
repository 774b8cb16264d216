#include "app/report/accuracy_markdown.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/report/integrator_settings.h"

namespace hazer::app {
namespace {

constexpr const char* kHowToRead =
    "Errors are differences to the converged picture of the light in the air, over its lit pixels (brighter "
    "than 1e-4 of\nthe brightest), as shares of the root mean square of that picture's light: *rms* their "
    "root "
    "mean square, *99 %* what 99\nof 100 lit pixels keep, *worst* the largest. *air* is the time of the "
    "passes that draw light in the air, *frame* adds\nall other passes; both are medians.\n";

std::string percent(double share) {
    return fmt::format("{:.2g} %", 100.0 * share);
}

std::string times(double factor) {
    return factor < 10.0 ? fmt::format("{:.1f}", factor) : fmt::format("{:.0f}", factor);
}

/// "equal error" of one scene in words for a table's cell.
std::string uniformCell(const EqualError& equal) {
    if (equal.uniform.isReached) return fmt::format("{:.1f} ms", equal.uniform.ms);
    return fmt::format("not reached: {} after {:.0f} ms", percent(equal.uniform.rmsRel), equal.uniform.ms);
}

std::string summaryRow(const AccuracyScene& scene) {
    const auto equal = equalError(scene);
    if (!equal) return {};
    const AccuracyRow* thesis = findRow(scene, kUniformName, samplesSetting(110));
    return fmt::format(
        "| [{}](#{}) | {:.2f} ms, {} | {} | {} | {}{} |\n", scene.name, scene.name, equal->angle->msMedian,
        percent(equal->angle->error.rmsRel),
        thesis == nullptr ? std::string("not measured")
                          : fmt::format("{:.2f} ms, {}", thesis->msMedian, percent(thesis->error.rmsRel)),
        uniformCell(*equal), equal->uniform.isReached ? "" : "more than ", times(equal->timesFaster));
}

std::string summary(const AccuracyReport& report) {
    std::string text =
        "\n## Summary\n\n"
        "| scene | angle, default | uniform, 110 samples | uniform at the error of angle, default | angle is "
        "faster, times |\n|---|---|---|---|---|\n";
    for (const AccuracyScene& scene : report.scenes) text += summaryRow(scene);
    return text;
}

std::string oracleSentence(const char* light, const OracleCheck& check) {
    const std::string outlines =
        check.outlines == 0 ? std::string()
                            : fmt::format("; {} more, on outlines of bodies, were left out", check.outlines);
    return fmt::format(
        "The converged picture of the light {} differs from the oracle by {} (rms) over {} lit pixels, {} at "
        "the worst{}.\n",
        light, percent(check.rmsRel), check.pixels, percent(check.maxRel), outlines);
}

std::string sceneSection(const AccuracyScene& scene) {
    std::string text = fmt::format("\n## {}\n\n{}.\n\n![Error against time]({})\n\n", scene.name, scene.title,
                                   plotFile(scene));
    if (scene.oracle) text += oracleSentence("in the air", *scene.oracle) + "\n";
    if (scene.wholeOracle) {
        text += oracleSentence("in the air and on surfaces", *scene.wholeOracle) + "\n";
    }
    text +=
        "| integrator | setting | air ms | frame ms | rms | 99 % | worst |\n|---|---|---|---|---|---|---|\n";
    for (const AccuracyRow& row : scene.rows) {
        text += fmt::format("| {} | {} | {:.2f} | {:.2f} | {} | {} | {} |\n", row.integrator, row.setting,
                            row.msMedian, row.frameMsMedian, percent(row.error.rmsRel),
                            percent(row.error.p99Rel), percent(row.error.maxRel));
    }
    for (const std::string& note : scene.notes) text += "\n" + note + "\n";
    return text;
}

/// The scene that the thesis measured, or the first one.
const AccuracyScene& sceneOfThesis(const AccuracyReport& report) {
    const auto thesis = std::find_if(report.scenes.begin(), report.scenes.end(),
                                     [](const AccuracyScene& scene) { return scene.name == "thesis"; });
    return thesis == report.scenes.end() ? report.scenes.front() : *thesis;
}

std::string thesisRow(const AccuracyRow& row) {
    return fmt::format("| {}, {} | {:.1f} | {:.1f} | {} |\n", row.integrator, row.setting,
                       1000.0 / row.frameMsMedian, 1000.0 / row.msMedian, percent(row.error.rmsRel));
}

std::string thesisTable(const AccuracyReport& report) {
    const AccuracyScene& scene = sceneOfThesis(report);
    std::string text = fmt::format(
        "\n## The thesis' table\n\nFrames a second of scene {} by samples of the thesis' method, and the "
        "error beside each rate.\n\n"
        "| method | frames/s | frames/s, air alone | rms error |\n|---|---|---|---|\n",
        scene.name);
    for (const int samples : thesisSamples()) {
        if (const AccuracyRow* row = findRow(scene, kUniformName, samplesSetting(samples))) {
            text += thesisRow(*row);
        }
    }
    if (const AccuracyRow* own = findRow(scene, kAngleName, kOwnSetting)) text += thesisRow(*own);
    return text;
}

}  // namespace

std::string plotFile(const AccuracyScene& scene) {
    return "accuracy-" + scene.name + ".svg";
}

std::string accuracyMarkdown(const AccuracyReport& report) {
    std::string text = fmt::format("# Error against run time\n\n{}, {} x {} pixels.\n\n{}", report.device,
                                   report.width, report.height, kHowToRead);
    text += summary(report);
    if (!report.scenes.empty()) text += thesisTable(report);
    for (const AccuracyScene& scene : report.scenes) text += sceneSection(scene);
    return text;
}

}  // namespace hazer::app
