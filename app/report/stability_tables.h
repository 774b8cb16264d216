// The stability report for people and for machines.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/report/motion_stability.h"
#include "app/report/stability_run.h"

namespace hazer::app {

struct StabilityReport {
    std::string device;               ///< As gl::describeContext() has it.
    std::vector<StabilityRow> light;  ///< Named cases.
    std::vector<StabilityRow> refusals;
    StabilityRow random;
    std::string worstRay;  ///< Parameters of the worst random ray.
    std::vector<MotionRow> motion;

    bool passed() const;
};

/// {"device", "passed", "light": [{"name", "rays", "not_finite", "below_zero", "compared", "median_error",
/// "p99_error", "worst_error", "verdict"}], "refusals": [{"name", "verdict"}], "random": as one of light,
/// with "worst_ray", "motion": [{"name", "steps", "worst_deviation", "verdict"}]}
nlohmann::ordered_json stabilityJson(const StabilityReport& report);

std::string stabilityMarkdown(const StabilityReport& report);

}  // namespace hazer::app
