// How long passes take on the GPU, read a few frames late so that nothing waits.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "render/gl/handle.h"

namespace hazer::render::gl {

/// beginFrame, then for each pass begin and end. `latest` holds the passes of the newest frame whose timers
/// have come back.
class PassTimer {
 public:
    void beginFrame();
    void begin(const char* pass);
    void end();

    /// Name and milliseconds.
    const std::vector<std::pair<std::string, double>>& latest() const { return latest_; }

 private:
    struct Frame {
        std::vector<Query> queries;
        std::vector<std::string> names;
    };
    void collect(const Frame& frame);

    static constexpr std::size_t kFramesInFlight = 3;
    std::array<Frame, kFramesInFlight> frames_;
    std::size_t current_ = 0;
    std::vector<std::pair<std::string, double>> latest_;
};

}  // namespace hazer::render::gl
