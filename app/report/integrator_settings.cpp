#include "app/report/integrator_settings.h"

#include <fmt/format.h>

namespace hazer::app {
namespace {

IntegratorSetting uniform(int samples) {
    render::Settings settings;
    settings.integrator = render::Integrator::kUniform;
    settings.samples = samples;
    return {kUniformName, samplesSetting(samples), settings};
}

IntegratorSetting angleNodes(int nodes) {
    render::Settings settings;
    settings.samples = nodes;
    return {kAngleName, fmt::format("{} nodes", nodes), settings};
}

}  // namespace

std::string samplesSetting(int samples) {
    return fmt::format("{} samples", samples);
}

const std::vector<int>& thesisSamples() {
    static const std::vector<int> kSamples{20, 40, 60, 80, 100, 120};
    return kSamples;
}

std::vector<IntegratorSetting> integratorSettings(bool isQuick) {
    const std::vector<int> uniformSamples =
        isQuick ? std::vector<int>{20, 40, 60, 80, 100, 110, 120, 440, 1760}
                : std::vector<int>{20, 40, 60, 80, 100, 110, 120, 440, 1760, 4096, 16384};
    const std::vector<int> nodes =
        isQuick ? std::vector<int>{4, 32} : std::vector<int>{4, 8, 16, 32, 64, 128};
    std::vector<IntegratorSetting> table;
    for (const int samples : uniformSamples) table.push_back(uniform(samples));
    table.push_back({kAngleName, kOwnSetting, {}});
    for (const int count : nodes) table.push_back(angleNodes(count));
    return table;
}

render::Settings convergedSettings(int nodes) {
    render::Settings settings;
    settings.samples = nodes;
    settings.airStep = 1;
    return settings;
}

}  // namespace hazer::app
