// Thick haze whose forward peak counts as light that was not scattered.
#pragma once

#include "render/scene.h"

namespace hazer::render {

/// The haze to integrate single scattering in: `haze` itself unless it asks for the delta-Eddington
/// approximation (Joseph, Wiscombe, Weinman 1976). That takes the share f = w g1^2 of the scattered light out
/// of the forward lobe and lets it go straight on. What is absorbed stays, and so does the mean cosine of all
/// that is scattered. A forward lobe that does not point forward has no peak.
Haze hazeToIntegrate(Haze haze);

}  // namespace hazer::render
