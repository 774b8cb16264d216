// Scenes of light in the air that nobody chose: what an error that is promised for any scene is tried on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/asset_sink.h"
#include "render/scene.h"

namespace hazer::test {

/// What random scenes are made of. One for all scenes of a renderer.
struct RandomAirAssets {
    std::vector<render::GoboId> gobos;
    render::MeshId box = -1;
    render::MeshId sphere = -1;
    render::MeshId plane = -1;
};

/// Adds meshes, and gobos of the moving spot that comes with hazer.
RandomAirAssets addRandomAirAssets(render::AssetSink& assets);

struct RandomAir {
    std::string what;  ///< In words: "2 beams, gobo, shadow, ...".
    render::Scene scene;
    render::Camera camera;
};

/// The same scene for the same seed on every machine: one to four beams, flat or soft, with or without a
/// gobo; up to three balls and boxes, down to thin bars, in their light; even or uneven haze of 0.005..1 /m;
/// a camera beside, inside or above. Bodies are black and lenses hidden, so that a picture holds the light in
/// the air alone.
RandomAir makeRandomAir(std::uint32_t seed, const RandomAirAssets& assets);

}  // namespace hazer::test
