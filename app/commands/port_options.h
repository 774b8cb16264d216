// The options --port and --sacn-port of commands that listen.
#pragma once

#include "app/inputs.h"

namespace CLI {
class App;
}

namespace hazer::app {

/// Adds --port (of Art-Net) and --sacn-port to a command; each is set if its option is given.
void addPortOptions(CLI::App& command, InputPorts& ports);

}  // namespace hazer::app
