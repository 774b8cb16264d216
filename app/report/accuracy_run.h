// Measures one scene of hazer report accuracy: draws it with every setting, times it, and holds it against
// the converged picture.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/report/accuracy_report.h"
#include "app/report/integrator_settings.h"
#include "app/session.h"

namespace hazer::app {

struct AccuracyOptions {
    std::vector<IntegratorSetting> settings;
    int oraclePixels = 200;
    double rowS = 1.0;       ///< Frames of one setting are repeated for about so long.
    double longestS = 30.0;  ///< A setting that is expected to take longer than this for a frame is left out.
};

/// `session` stands as it is to be drawn, with size and camera. `step` is called before each setting. Throws
/// std::runtime_error if there is no light in the air.
AccuracyScene measureAccuracy(Session& session, const AccuracyOptions& options,
                              const std::function<void()>& step);

}  // namespace hazer::app
