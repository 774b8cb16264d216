// The accuracy report as a folder of files.
#pragma once

#include <filesystem>

#include "app/report/accuracy_report.h"

namespace hazer::app {

/// The plot of one scene: a line for each integrator.
std::string accuracyPlot(const AccuracyScene& scene);

/// Writes accuracy.json, accuracy.csv, accuracy.md and accuracy-SCENE.svg into a folder, which is made if it
/// is missing. Throws std::runtime_error.
void writeAccuracyReport(const AccuracyReport& report, const std::filesystem::path& folder);

}  // namespace hazer::app
