// Whose inputs a command hears that watches a network: those of a show, or whatever there is.
#pragma once

#include <string>
#include <vector>

#include "app/inputs.h"

namespace CLI {
class App;
}

namespace hazer::app {

struct WatchedInputs {
    std::string show;                        ///< Empty: none.
    std::vector<std::string> sacnUniverses;  ///< Lists of numbers, as parseNumberList takes them.
    InputPorts ports;
};

/// Adds SHOW, --universe, --port and --sacn-port to a command.
void addWatchedInputs(CLI::App& command, WatchedInputs& watched);

/// The show, with every input there is if it has none itself, and sACN among them if universes of it are
/// named. Throws ShowError.
Show showToWatch(const WatchedInputs& watched);

/// How Inputs of that show listen. Universes of sACN that are announced are joined unless a show says what to
/// hear.
ListenOptions listenOptionsOf(const WatchedInputs& watched);

}  // namespace hazer::app
