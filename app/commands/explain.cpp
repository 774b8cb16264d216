// hazer explain: what a frame of a show needs, what was left out of it, why, and what that saves.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/assignment.h"
#include "app/commands/command.h"
#include "app/commands/integrator_option.h"
#include "app/commands/size_option.h"
#include "app/explanation.h"

namespace hazer::app {
namespace {

struct ExplainOptions {
    std::string show;
    ExplainRequest request;
    Size size;
    bool hasNoBloom = false;
    bool isJson = false;
};

int runExplain(ExplainOptions options) {
    options.request.width = options.size.width;
    options.request.height = options.size.height;
    options.request.bloom = !options.hasNoBloom;
    const Explanation explanation = explainShow(loadShow(options.show), options.request);
    if (options.isJson) {
        // Names come from other people's files: what is not UTF-8 in them must not end the program.
        fmt::print("{}\n", explanationJson(explanation)
                               .dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    } else {
        fmt::print("{}", explanationText(explanation));
    }
    return kExitOk;
}

}  // namespace

void addExplainCommand(CLI::App& program, Command& chosen) {
    auto options = std::make_shared<ExplainOptions>();
    CLI::App* command = program.add_subcommand(
        "explain", "Say what a frame of a show needs, what was left out of it, and why.");
    beginHelpWith(*command,
                  "  hazer explain myshow.toml                            as the show stands without a desk\n"
                  "  hazer explain myshow.toml --set spot1.Dimmer=1       with a lamp lit by hand\n"
                  "  hazer explain myshow.toml --size 3840x2160 --json    for machines\n");
    command->add_option("SHOW", options->show, "The show file (.toml) or rig (.mvr)")->required();
    command
        ->add_option(
            "--set", options->request.assignments,
            "Hold an attribute, FIXTURE.Attribute=VALUE (deg, Hz, 0..1, slot of a wheel); may be repeated")
        ->check(checkAssignment);
    addSizeOption(*command, options->size);
    command->add_option("--camera", options->request.camera,
                        "Name of a camera of the show; its first unless given");
    addIntegratorOption(*command, options->request.integrator);
    command->add_flag("--no-bloom", options->hasNoBloom, "Without the glow around bright light");
    command->add_flag("--json", options->isJson, "Print JSON");
    command->callback([options, &chosen] { chosen = [options] { return runExplain(*options); }; });
}

}  // namespace hazer::app
