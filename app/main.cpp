// The program: reads the command line, runs the command, turns its error into one sentence and an exit code.
#include <fmt/format.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>

#include "app/commands/command.h"
#include "render/error.h"

namespace {

using namespace hazer::app;

/// Results go to stdout; whatever is said on the way goes to stderr, so that a pipe stays clean.
void logToStandardError() {
    auto logger =
        std::make_shared<spdlog::logger>("hazer", std::make_shared<spdlog::sinks::stderr_sink_mt>());
    logger->set_pattern("hazer: %l: %v");
    spdlog::set_default_logger(std::move(logger));
}

int run(const Command& command) {
    try {
        return command();
    } catch (const hazer::render::NoGlError& error) {
        fmt::print(stderr, "hazer: {}\n", error.what());
        return kExitNoGl;
    } catch (const std::exception& error) {
        fmt::print(stderr, "hazer: {}\n", error.what());
        return kExitBadInput;
    }
}

}  // namespace

int main(int argumentCount, char** arguments) {
    logToStandardError();
    CLI::App program("See the show before the rig is hung: DMX in, light in the air out.", "hazer");
    beginHelpWith(
        program,
        "  hazer demo                                  the show that comes with hazer, played to itself\n"
        "  hazer live myshow.toml                      watch a show, driven by your desk over Art-Net\n"
        "  hazer render myshow.toml --out look.png     a picture, no window needed\n"
        "  hazer COMMAND --help                        examples and options of one command\n");
    program.set_version_flag("--version", "hazer " HAZER_VERSION);
    // One or none: with "at least one" a mistyped command would only be told that a command is missing.
    program.require_subcommand(0, 1);
    Command chosen;
    addLiveCommand(program, chosen);
    addDemoCommand(program, chosen);
    addRenderCommand(program, chosen);
    addReportCommand(program, chosen);
    addSendCommand(program, chosen);
    addMonitorCommand(program, chosen);
    addRecordCommand(program, chosen);
    addReplayCommand(program, chosen);
    addInspectCommand(program, chosen);
    addExplainCommand(program, chosen);
    addLibraryCommand(program, chosen);
    try {
        program.parse(argumentCount, arguments);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? kExitOk : kExitUsage;
    }
    if (!chosen) {
        fmt::print(stderr, "{}", program.help());
        return kExitUsage;
    }
    return run(chosen);
}
