// hazer report speed: how long the passes of a show's frames take.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/integrator_option.h"
#include "app/commands/max_error_option.h"
#include "app/commands/report.h"
#include "app/commands/size_option.h"
#include "app/demo_programme.h"
#include "app/paths.h"
#include "app/picture_file.h"
#include "app/report/speed_report.h"
#include "app/report/text_file.h"
#include "render/gl/headless_context.h"

namespace hazer::app {
namespace {

struct SpeedOptions {
    std::string show;
    std::string out;
    render::Integrator integrator = render::Integrator::kAngle;
    Size size;
    int frames = 30;
    double maxError = 0.0;
    bool isJson = false;
};

int runSpeed(const SpeedOptions& options) {
    Show show =
        loadShow(options.show.empty() ? showFolder() / "demo.toml" : std::filesystem::path(options.show));
    const render::gl::HeadlessContext context;
    Session session(std::move(show), {});
    session.settings().width = options.size.width;
    session.settings().height = options.size.height;
    session.settings().maxError = options.maxError;
    session.settings().integrator = options.integrator;
    session.setTime(kStrikingMomentS);
    const SpeedReport report = measureSpeed(session, options.frames);
    const std::string json = speedJson(report).dump(2) + "\n";
    const std::string markdown = speedMarkdown(report);
    if (!options.out.empty()) {
        makeFolder(options.out);
        writeText(std::filesystem::path(options.out) / "speed.json", json);
        writeText(std::filesystem::path(options.out) / "speed.md", markdown);
    }
    fmt::print("{}", options.isJson ? json : markdown);
    return kExitOk;
}

}  // namespace

void addSpeedReport(CLI::App& report, Command& chosen) {
    auto options = std::make_shared<SpeedOptions>();
    CLI::App* command = report.add_subcommand("speed", "How long each pass of a show's frames takes.");
    beginHelpWith(*command,
                  "  hazer report speed                              the show that comes with hazer\n"
                  "  hazer report speed myshow.toml --size 1920x1080 --max-error 1%\n"
                  "  hazer report speed myshow.toml --json --out my-report\n");
    command->add_option("SHOW", options->show, "The show file (.toml); the demo unless given");
    addSizeOption(*command, options->size);
    command->add_option("--frames", options->frames, "Frames that count, 1..10000; 30 unless given")
        ->check(CLI::Range(1, 10000));
    addIntegratorOption(*command, options->integrator);
    addMaxErrorOption(*command, options->maxError);
    command->add_option("--out", options->out, "Folder that speed.json and speed.md are written into, too");
    command->add_flag("--json", options->isJson, "Print JSON");
    command->callback([options, &chosen] { chosen = [options] { return runSpeed(*options); }; });
}

}  // namespace hazer::app
