#include "app/commands/port_options.h"

#include <CLI/CLI.hpp>

namespace hazer::app {

void addPortOptions(CLI::App& command, InputPorts& ports) {
    command.add_option("--port", ports.artNet, "UDP port of Art-Net instead of those of the show's inputs")
        ->check(CLI::Range(0, 65535));
    command.add_option("--sacn-port", ports.sacn, "UDP port of sACN instead of those of the show's inputs")
        ->check(CLI::Range(0, 65535));
}

}  // namespace hazer::app
