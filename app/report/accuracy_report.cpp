#include "app/report/accuracy_report.h"

#include <algorithm>

#include "app/report/integrator_settings.h"

namespace hazer::app {

const AccuracyRow* findRow(const AccuracyScene& scene, const std::string& integrator,
                           const std::string& setting) {
    const auto row = std::find_if(scene.rows.begin(), scene.rows.end(), [&](const AccuracyRow& other) {
        return other.integrator == integrator && other.setting == setting;
    });
    return row == scene.rows.end() ? nullptr : &*row;
}

std::optional<EqualError> equalError(const AccuracyScene& scene) {
    const AccuracyRow* angle = findRow(scene, kAngleName, kOwnSetting);
    std::vector<TimedError> uniform;
    for (const AccuracyRow& row : scene.rows) {
        if (row.integrator == kUniformName) uniform.push_back({row.msMedian, row.error.rmsRel});
    }
    if (angle == nullptr || uniform.empty()) return std::nullopt;
    EqualError equal{angle, timeAtError(uniform, angle->error.rmsRel), 0.0};
    equal.timesFaster = equal.uniform.ms / angle->msMedian;
    return equal;
}

}  // namespace hazer::app
