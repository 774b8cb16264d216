// The parts of hazer report.
#pragma once

#include "app/commands/command.h"

namespace hazer::app {

// Each adds one report with its options to `hazer report`; if it is the one asked for, `chosen` becomes it.
void addAccuracyReport(CLI::App& report, Command& chosen);
void addSpeedReport(CLI::App& report, Command& chosen);
void addStabilityReport(CLI::App& report, Command& chosen);

}  // namespace hazer::app
