#include "app/report/frame_medians.h"

#include <algorithm>
#include <chrono>
#include <ctime>

#include "app/report/statistics.h"

namespace hazer::app {
namespace {

constexpr int kWarmUpFrames = 3;

double cpuMs() {
    return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// What was measured of a pass, a value a frame.
struct PassTimes {
    std::string name;
    std::vector<double> ms;
};

void append(const std::vector<render::PassTime>& frame, std::vector<PassTimes>& passes) {
    for (const render::PassTime& pass : frame) {
        auto known = std::find_if(passes.begin(), passes.end(),
                                  [&](const PassTimes& other) { return other.name == pass.name; });
        if (known == passes.end()) known = passes.insert(passes.end(), {pass.name, {}});
        known->ms.push_back(pass.milliseconds);
    }
}

}  // namespace

FrameMedians measureFrames(Session& session, int frames, const std::function<void(int)>& prepare) {
    std::vector<double> wall, cpu;
    std::vector<PassTimes> passes;
    for (int frame = 0; frame < frames + kWarmUpFrames; ++frame) {
        prepare(frame);
        const auto start = std::chrono::steady_clock::now();
        const double cpuBefore = cpuMs();
        session.draw();
        session.renderer().readDisplay();
        if (frame < kWarmUpFrames) continue;
        cpu.push_back(cpuMs() - cpuBefore);
        wall.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
        append(session.renderer().lastPassTimes(), passes);
    }
    FrameMedians medians{median(wall), median(cpu), {}};
    for (const PassTimes& pass : passes) medians.passes.push_back({pass.name, median(pass.ms)});
    return medians;
}

}  // namespace hazer::app
