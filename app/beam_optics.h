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

/// Puts gobos, iris, blades, animation, split colours, the beam's own shape and frost in its way. The beam
/// must be as the fixture sends it without any of them.
void applyOptics(const fixtures::BeamState& state, const GoboLookup& goboFor, render::Beam& beam);

/// Appends the copies that the prisms in the beam make of it, at most 64, which have its light between them;
/// the beam itself if there is no prism.
void appendCopies(const fixtures::BeamState& state, const render::Beam& beam,
                  std::vector<render::Beam>& beams);

}  // namespace hazer::app
