// The option --integrator of commands that draw.
#pragma once

#include <CLI/CLI.hpp>

#include "render/scene.h"

namespace hazer::app {

/// Adds --integrator, `angle` or `uniform`. `integrator` is set if the option is given.
void addIntegratorOption(CLI::App& command, render::Integrator& integrator);

}  // namespace hazer::app
