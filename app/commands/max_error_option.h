// The option --max-error of commands that draw.
#pragma once

namespace CLI {
class App;
}

namespace hazer::app {

/// Adds --max-error to a command: a share such as 1% or 0.01, from 0.01 % to 50 %, of the root mean square of
/// the light in the air. `maxError` (a share) is set if the option is given.
void addMaxErrorOption(CLI::App& command, double& maxError);

}  // namespace hazer::app
