// The accuracy report for people.
#pragma once

#include <string>

#include "app/report/accuracy_report.h"

namespace hazer::app {

/// Name of a scene's plot, beside the report.
std::string plotFile(const AccuracyScene& scene);

/// What was measured and how, the summary, a section with table and plot for each scene, and the thesis' own
/// table of frames a second.
std::string accuracyMarkdown(const AccuracyReport& report);

}  // namespace hazer::app
