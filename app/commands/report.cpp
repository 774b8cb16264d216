// hazer report: what the pictures are worth and what they cost, measured on the user's own machine.
#include "app/commands/report.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

namespace hazer::app {

void addReportCommand(CLI::App& program, Command& chosen) {
    CLI::App* command = program.add_subcommand(
        "report", "Measure what pictures are worth and what they cost on this machine.");
    beginHelpWith(*command,
                  "  hazer report accuracy                 error against run time, with plots\n"
                  "  hazer report speed myshow.toml        how long each pass of a frame takes\n"
                  "  hazer report stability                stiff and extreme cases, number by number\n");
    // One or none, as for the program itself: a mistyped report is then named.
    command->require_subcommand(0, 1);
    addAccuracyReport(*command, chosen);
    addSpeedReport(*command, chosen);
    addStabilityReport(*command, chosen);
    command->callback([command, &chosen] {
        if (!command->get_subcommands().empty()) return;
        chosen = [command] {
            fmt::print(stderr, "{}", command->help("hazer"));
            return kExitUsage;
        };
    });
}

}  // namespace hazer::app
