// hazer report speed: how long each pass of a show's frames takes.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/report/frame_medians.h"

namespace hazer::app {

struct SpeedReport {
    std::string device;  ///< As gl::describeContext() has it.
    std::string show;
    int width = 0;
    int height = 0;
    int frames = 0;
    FrameMedians medians;
};

/// Draws `frames` frames of a show from session.timeS() on, 1/25 s apart so that what moves has to be drawn
/// anew. The demo that comes with hazer is played as `hazer demo` plays it; of any other show, what is held
/// is lit.
SpeedReport measureSpeed(Session& session, int frames);

/// {"device", "show", "size": [w, h], "frames", "fps", "frame_ms_median", "cpu_ms_median", "passes":
/// [{"name", "ms_median"}]}
nlohmann::ordered_json speedJson(const SpeedReport& report);

/// The same as a table for people.
std::string speedMarkdown(const SpeedReport& report);

}  // namespace hazer::app
