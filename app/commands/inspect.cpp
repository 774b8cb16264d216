// hazer inspect: what is in a fixture file or a show.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "app/fixture_library.h"
#include "app/inspection.h"
#include "fixtures/gdtf.h"

namespace hazer::app {
namespace {

struct InspectOptions {
    std::string file;
    bool isJson = false;
};

/// Names come from other people's files: what is not UTF-8 in them must not end the program.
std::string printable(const nlohmann::ordered_json& json) {
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string inspectShow(const InspectOptions& options) {
    const Show show = loadShow(options.file);
    const Patch patch(show);
    for (const std::string& overlap : patch.overlaps()) {
        fmt::print(stderr, "hazer: warning: {}: {}\n", options.file, overlap);
    }
    return options.isJson ? printable(describeShow(show, patch)) : summarizeShow(show, patch);
}

std::string inspectFixtureType(const InspectOptions& options) {
    const fixtures::FixtureTypePtr type = fixtures::loadGdtf(resolveGdtf(options.file, {}));
    return options.isJson ? printable(describeFixtureType(*type)) : summarizeFixtureType(*type);
}

int runInspect(const InspectOptions& options) {
    const bool isShow = std::filesystem::path(options.file).extension() == ".toml";
    fmt::print("{}", isShow ? inspectShow(options) : inspectFixtureType(options));
    return kExitOk;
}

}  // namespace

void addInspectCommand(CLI::App& program, Command& chosen) {
    auto options = std::make_shared<InspectOptions>();
    CLI::App* command = program.add_subcommand("inspect", "Say what is in a fixture file (GDTF) or a show.");
    beginHelpWith(*command,
                  "  hazer inspect myshow.toml            which fixture listens to which slots\n"
                  "  hazer inspect fixture.gdtf           modes, channels and wheels\n"
                  "  hazer inspect moving-spot --json     a fixture that comes with hazer, for machines\n");
    command
        ->add_option("FILE", options->file,
                     "A show (.toml), a .gdtf file or its unpacked folder, or a fixture of hazer's library")
        ->required();
    command->add_flag("--json", options->isJson, "Print JSON");
    command->callback([options, &chosen] { chosen = [options] { return runInspect(*options); }; });
}

}  // namespace hazer::app
