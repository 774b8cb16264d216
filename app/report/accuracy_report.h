// What hazer report accuracy finds out, as plain data.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/report/statistics.h"

namespace hazer::app {

/// One setting of one integrator on one scene.
struct AccuracyRow {
    std::string integrator;      ///< "angle", "uniform".
    std::string setting;         ///< As the report's tables name it.
    int samples = 0;             ///< 0: as many as the beam needs.
    int frames = 0;              ///< That the medians are of.
    double msMedian = 0.0;       ///< Light in the air alone.
    double frameMsMedian = 0.0;  ///< With all other passes of the show's frame.
    PictureError error;          ///< Against the converged picture.
};

/// How far a converged picture is from the oracle, over some of its lit pixels; shares of the root mean
/// square of the oracle's light there.
struct OracleCheck {
    std::size_t pixels = 0;
    std::size_t outlines = 0;  ///< Further pixels that were drawn, but lie on the outline of a body.
    double rmsRel = 0.0;
    double maxRel = 0.0;
};

struct AccuracyScene {
    std::string name;
    std::string title;
    std::vector<AccuracyRow> rows;           ///< Of one integrator together, from cheap to dear.
    std::optional<OracleCheck> oracle;       ///< Of the light in the air alone, which rows are held against.
    std::optional<OracleCheck> wholeOracle;  ///< Of the show's picture, with surfaces.
    std::vector<std::string> notes;          ///< Sentences: what was left out, and why.
};

struct AccuracyReport {
    std::string device;  ///< As gl::describeContext() has it.
    int width = 0;
    int height = 0;
    std::vector<AccuracyScene> scenes;
};

/// The angle integrator as it runs unless told otherwise, against the uniform one.
struct EqualError {
    const AccuracyRow* angle = nullptr;
    TimeAtError uniform;       ///< At the error of `angle`.
    double timesFaster = 0.0;  ///< uniform.ms / angle->msMedian; at least that if not reached.
};

/// Empty if the scene has no row of the angle integrator's own setting, or none of the uniform one.
std::optional<EqualError> equalError(const AccuracyScene& scene);

/// The row of that integrator and setting; null if there is none.
const AccuracyRow* findRow(const AccuracyScene& scene, const std::string& integrator,
                           const std::string& setting);

}  // namespace hazer::app
