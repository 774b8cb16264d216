// What a fixture's optics do to one of its beams: from wheels, blades, frost and prisms to what the renderer
// draws.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "fixtures/fixture.h"
#include "render/scene.h"

namespace hazer::app {

/// Gives the renderer's handle for a wheel's picture.
using GoboLookup = std::function<render::GoboId(const std::shared_ptr<const fixtures::WheelImage>&)>;

/// Puts gobos, iris, blades, animation, split colours and the beam's own shape in its way, and widens it by
/// its frost. The beam must be as the fixture sends it without any of them.
void applyOptics(const fixtures::BeamState& state, const GoboLookup& goboFor, render::Beam& beam);

/// The copies that the prisms in the beam make of it; the beam itself if there is none. At most 64. A facet
/// that stretches the image one way makes the beam oval, and leaves its gobos unstretched.
std::vector<render::Beam> throughPrisms(const fixtures::BeamState& state, const render::Beam& beam);

}  // namespace hazer::app
