// The settings of the integrators that reports compare: one table.
#pragma once

#include <string>
#include <vector>

#include "render/scene.h"

namespace hazer::app {

inline const std::string kAngleName = "angle";
inline const std::string kUniformName = "uniform";
inline const std::string kOwnSetting = "default";  ///< Of an integrator that is told nothing.

struct IntegratorSetting {
    std::string integrator;
    std::string setting;
    render::Settings settings;  ///< Without size and exposure.
};

/// From cheap to dear; the quick table has fewer of each.
std::vector<IntegratorSetting> integratorSettings(bool isQuick);

/// The name of the uniform integrator's setting with so many samples.
std::string samplesSetting(int samples);

/// The thesis' own numbers of samples: of its table of frames a second.
const std::vector<int>& thesisSamples();

/// The angle integrator at every pixel with so many nodes: what the others are held against.
render::Settings convergedSettings(int nodes);

}  // namespace hazer::app
