// Uneven haze as the oracle has it: the density of the air at a place, worked out anew in double.
#pragma once

#include <functional>
#include <glm/glm.hpp>

#include "render/scene.h"

namespace hazer::render::oracle {

/// Density of the haze over its mean at a place of the world [m].
using Density = std::function<double(const glm::dvec3&)>;

/// The noise of docs/rendering.md at `timeS`; empty where the haze is even.
Density hazeDensity(const Haze& haze, double timeS);

}  // namespace hazer::render::oracle
