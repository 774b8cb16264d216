// hazer live: a window that shows what the desk does.
#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <stdexcept>

#include "app/commands/command.h"
#include "app/commands/max_error_option.h"
#include "app/commands/port_options.h"
#include "app/display.h"
#include "app/paths.h"
#include "render/air_quality.h"

namespace hazer::app {
namespace {

struct LiveOptions {
    std::string show;
    InputPorts ports;
    std::optional<int> frames;
    double maxError = render::kDefaultMaxError;
};

int runLive(const LiveOptions& options) {
    const std::filesystem::path file =
        options.show.empty() ? showFolder() / "one-spot.toml" : std::filesystem::path(options.show);
    const auto setQuality = [&](Session& session) { session.settings().maxError = options.maxError; };
    return showInWindow(loadShow(file), {.listen = true, .ports = options.ports, .scrubs = true}, setQuality,
                        options.frames);
}

}  // namespace

void addLiveCommand(CLI::App& program, Command& chosen) {
    auto options = std::make_shared<LiveOptions>();
    CLI::App* command =
        program.add_subcommand("live", "Watch a show in a window, driven by a desk over Art-Net or sACN.");
    beginHelpWith(*command,
                  "  hazer live                       one moving spot, on Port-Address 0 from slot 1\n"
                  "  hazer live myshow.toml           your own rig\n"
                  "  hazer live rig.mvr               a rig from a drawing program, on Art-Net and sACN\n"
                  "  hazer live myshow.toml --port 6455\n");
    command->add_option("SHOW", options->show,
                        "The show file (.toml) or rig (.mvr); a single moving spot unless given");
    addPortOptions(*command, options->ports);
    addMaxErrorOption(*command, options->maxError);
    command->add_option("--frames", options->frames, "Close after this many pictures, for tests")
        ->check(CLI::PositiveNumber)
        ->group("");  // not shown in --help
    command->callback([options, &chosen] { chosen = [options] { return runLive(*options); }; });
}

}  // namespace hazer::app
