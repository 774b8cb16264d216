#include "app/report/accuracy_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/picture_file.h"
#include "app/report/accuracy_markdown.h"
#include "app/report/accuracy_tables.h"
#include "app/report/error_plot.h"
#include "app/report/integrator_settings.h"
#include "app/report/text_file.h"

namespace hazer::app {

std::string accuracyPlot(const AccuracyScene& scene) {
    std::vector<PlotLine> lines;
    for (const AccuracyRow& row : scene.rows) {
        auto line = std::find_if(lines.begin(), lines.end(),
                                 [&](const PlotLine& other) { return other.name == row.integrator; });
        if (line == lines.end()) line = lines.insert(lines.end(), {row.integrator, {}});
        // "max-error 5%" is "5%" beside its point.
        const std::string last = row.setting.substr(row.setting.rfind(' ') + 1);
        const std::string label = row.samples > 0 ? fmt::format("{}", row.samples) : last;
        line->points.push_back({row.msMedian, row.error.rmsRel, label, row.setting == kOwnSetting});
    }
    return errorPlot(scene.title, lines);
}

void writeAccuracyReport(const AccuracyReport& report, const std::filesystem::path& folder) {
    makeFolder(folder);
    writeText(folder / "accuracy.json", accuracyJson(report).dump(2) + "\n");
    writeText(folder / "accuracy.csv", accuracyCsv(report));
    writeText(folder / "accuracy.md", accuracyMarkdown(report));
    for (const AccuracyScene& scene : report.scenes) {
        writeText(folder / plotFile(scene), accuracyPlot(scene));
    }
}

}  // namespace hazer::app
