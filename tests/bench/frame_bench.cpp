// How long the passes of a frame take: draws a shipped show again and again and prints medians, as `hazer
// report speed` does of any show.
//     frame_bench [--show demo.toml] [--size 1280x720] [--frames 30] [--time 9] [--integrator angle|uniform]
//     [--json]
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "app/demo_programme.h"
#include "app/paths.h"
#include "app/report/speed_report.h"
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
    session.setTime(options.timeS);
    if (options.uniform) session.settings().integrator = hazer::render::Integrator::kUniform;
    const hazer::app::SpeedReport report = hazer::app::measureSpeed(session, options.frames);
    fmt::print("{}", options.json ? speedJson(report).dump(2) + "\n" : speedMarkdown(report));
    return 0;
}
