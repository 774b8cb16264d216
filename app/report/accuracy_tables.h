// The accuracy report for machines: JSON and CSV.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/report/accuracy_report.h"

namespace hazer::app {

/// {"device", "size": [w, h], "rows": [{"scene", "integrator", "setting", "samples", "ms_median", "rms_rel",
/// "p99_rel", "max_rel", "unlit_max_rel", "frame_ms_median", "frames", "lit_pixels"}], "oracle": [{"scene",
/// "light", "pixels", "outlines", "rms_rel", "max_rel"}], "equal_error": [{"scene", "rms_rel", "angle_ms",
/// "uniform_ms", "uniform_reaches_it", "uniform_rms_rel", "times_faster"}], "notes": [{"scene", "note"}]}.
/// Errors that are no numbers are null.
nlohmann::ordered_json accuracyJson(const AccuracyReport& report);

/// The rows alone, under a line of the same names.
std::string accuracyCsv(const AccuracyReport& report);

}  // namespace hazer::app
