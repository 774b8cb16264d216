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

/// As --max-error asks for.
IntegratorSetting angleWithin(double maxErrorPercent) {
    render::Settings settings;
    settings.maxError = maxErrorPercent / 100.0;
    return {kAngleName, fmt::format("max-error {:g}%", maxErrorPercent), settings};
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
    const std::vector<double> percents =
        isQuick ? std::vector<double>{5.0, 1.0}
                : std::vector<double>{20.0, 10.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1, 0.01};
    std::vector<IntegratorSetting> table;
    for (const int samples : uniformSamples) table.push_back(uniform(samples));
    for (const double percent : percents) table.push_back(angleWithin(percent));
    table.push_back({kAngleName, kOwnSetting, {}});
    return table;
}

render::Settings convergedSettings(int nodes) {
    render::Settings settings;
    settings.samples = nodes;
    settings.airStep = 1;
    return settings;
}

}  // namespace hazer::app
