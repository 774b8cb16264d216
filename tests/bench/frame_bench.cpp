// How long the passes of a frame take: draws a shipped show again and again and prints medians.
//     frame_bench [--show demo.toml] [--size 1280x720] [--frames 30] [--time 9] [--integrator angle|uniform]
//     [--json]
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <ctime>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/demo_programme.h"
#include "app/paths.h"
#include "app/session.h"
#include "protocol/dmx.h"
#include "render/gl/headless_context.h"

namespace {

struct Options {
    std::string show = "demo.toml";
    int width = 1280;
    int height = 720;
    int frames = 30;
    double timeS = hazer::app::kStrikingMomentS;
    bool uniform = false;
    bool json = false;
};

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                     values.end());
    return values[values.size() / 2];
}

/// CPU time of the whole process, all threads: steady on a busy machine, where wall time is not.
double cpuMs() {
    return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void playDemo(hazer::app::Session& session, double timeS) {
    for (hazer::app::PatchedFixture& patched : session.patch().fixtures()) {
        hazer::protocol::Slots slots{};
        hazer::app::writeDemoLook(patched.fixture, timeS, slots);
        patched.fixture.decode(slots);
    }
}

/// Milliseconds by pass name, one value a frame; "frame (CPU)" is the whole frame on all cores.
std::map<std::string, std::vector<double>> measure(hazer::app::Session& session, const Options& options) {
    constexpr int kWarmUpFrames = 3;
    std::map<std::string, std::vector<double>> times;
    for (int frame = 0; frame < options.frames + kWarmUpFrames; ++frame) {
        // The film's frame rate: lamps move, so that no shadow map is kept from the last frame for nothing.
        const double timeS = options.timeS + frame / 25.0;
        if (options.show == "demo.toml") playDemo(session, timeS);
        session.settle();
        session.setTime(timeS);
        const double before = cpuMs();
        session.draw();
        session.renderer().readDisplay();
        if (frame < kWarmUpFrames) continue;
        times["frame (CPU)"].push_back(cpuMs() - before);
        for (const auto& pass : session.renderer().passTimes()) times[pass.name].push_back(pass.milliseconds);
    }
    return times;
}

Options parse(int argc, char** argv) {
    Options options;
    std::string size = "1280x720";
    std::string integrator = "angle";
    CLI::App app{"Times the passes of a frame of a shipped show"};
    app.add_option("--show", options.show);
    app.add_option("--size", size);
    app.add_option("--frames", options.frames)->check(CLI::Range(1, 100000));
    app.add_option("--time", options.timeS);
    app.add_option("--integrator", integrator)->check(CLI::IsMember({"angle", "uniform"}));
    app.add_flag("--json", options.json);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        std::exit(app.exit(error));
    }
    if (std::sscanf(size.c_str(), "%dx%d", &options.width, &options.height) != 2) std::exit(1);
    options.uniform = integrator == "uniform";
    return options;
}

}  // namespace

int main(int argc, char** argv) {
    const Options options = parse(argc, argv);
    const hazer::render::gl::HeadlessContext context;
    hazer::app::Session session(hazer::app::loadShow(hazer::app::showFolder() / options.show), {});
    session.settings().width = options.width;
    session.settings().height = options.height;
    if (options.uniform) session.settings().integrator = hazer::render::Integrator::kUniform;
    const auto times = measure(session, options);
    nlohmann::json report{{"device", hazer::render::gl::describeContext()},
                          {"show", options.show},
                          {"size", {options.width, options.height}},
                          {"frames", options.frames}};
    for (const auto& [name, values] : times) report["ms_median"][name] = median(values);
    if (options.json) {
        fmt::print("{}\n", report.dump(2));
        return 0;
    }
    fmt::print("{}, {} at {}x{}, median of {} frames\n", report["device"].get<std::string>(), options.show,
               options.width, options.height, options.frames);
    for (const auto& [name, values] : times) fmt::print("{:14} {:8.2f} ms\n", name, median(values));
    return 0;
}
