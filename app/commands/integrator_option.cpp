#include "app/commands/integrator_option.h"

#include <string>

namespace hazer::app {

void addIntegratorOption(CLI::App& command, render::Integrator& integrator) {
    const auto take = [&integrator](const std::string& name) {
        integrator = name == "uniform" ? render::Integrator::kUniform : render::Integrator::kAngle;
    };
    command
        .add_option_function<std::string>("--integrator", take,
                                          "How light in the haze is summed; angle unless given")
        ->check(CLI::IsMember({"angle", "uniform"}));
}

}  // namespace hazer::app
