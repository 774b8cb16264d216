// How long the frames of a running show take, pass by pass.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/session.h"

namespace hazer::app {

struct PassMedian {
    std::string name;
    double ms = 0.0;
};

/// Medians over frames.
struct FrameMedians {
    double frameMs = 0.0;  ///< From the start of a frame until its picture has been read back.
    double cpuMs =
        0.0;  ///< CPU time of all threads: steady on a busy machine, where time on the wall is not.
    std::vector<PassMedian> passes;  ///< In the order in which they are drawn.
};

/// Draws a few frames to warm up, then `frames` > 0 that count. `prepare(i)` is called before each, i from 0.
FrameMedians measureFrames(Session& session, int frames, const std::function<void(int)>& prepare);

}  // namespace hazer::app
