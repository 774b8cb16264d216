// Points a fixture at a place.
#pragma once

#include <glm/glm.hpp>

#include "fixtures/fixture.h"

namespace hazer::app {

/// Presets pan and tilt so that the fixture's first beam goes to `targetM` until DMX says otherwise, as near
/// as they reach. A fixture without both is turned as a whole, as a person would hang it. Nothing happens if
/// it has no beam or stands at the target.
void aim(fixtures::Fixture& fixture, const glm::dvec3& targetM);

}  // namespace hazer::app
