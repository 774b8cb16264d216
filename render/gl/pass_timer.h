// How long the passes of a frame take.
#pragma once

#include <array>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "render/gl/handle.h"

namespace hazer::render::gl {

/// beginFrame, then for each pass begin and end. On a GPU its own clock is read a few frames late, so that
/// nothing waits. A software rasteriser puts work off and its clock with it; there each pass is waited for
/// and timed from outside, which costs it nothing.
class PassTimer {
 public:
    PassTimer();

    void beginFrame();
    void begin(const char* pass);
    void end();

    /// Name and milliseconds of the passes of the newest frame that is known.
    const std::vector<std::pair<std::string, double>>& latest() const { return latest_; }

    /// The same of the frame that was ended last; waits for it.
    std::vector<std::pair<std::string, double>> last() const;

 private:
    struct Frame {
        std::vector<Query> queries;
        std::vector<std::string> names;
    };
    void collect(const Frame& frame);
    static std::vector<std::pair<std::string, double>> timesOf(const Frame& frame);

    static constexpr std::size_t kFramesInFlight = 3;
    bool software_ = false;
    std::array<Frame, kFramesInFlight> frames_;
    std::size_t current_ = 0;
    std::chrono::steady_clock::time_point started_;
    std::vector<std::pair<std::string, double>> running_;
    std::vector<std::pair<std::string, double>> latest_;
};

}  // namespace hazer::render::gl
