// The part of a show that a person wants to see as a whole.
#pragma once

#include <glm/glm.hpp>

#include "app/show.h"

namespace hazer::app {

struct Ball {
    glm::dvec3 centreM{0.0};
    double radiusM = 1.0;
};

/// A ball around the fixtures, the floor under them and the objects, but not around floors and walls, which
/// mostly reach far beyond the stage.
Ball ballAroundStage(const Show& show);

}  // namespace hazer::app
