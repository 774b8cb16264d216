// One scene with every feature of a frame, and the same with each feature taken away: for tests of what is
// left out, and for measuring what each feature costs.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "render/asset_sink.h"
#include "render/scene.h"

namespace hazer::test {

struct FeatureScene {
    render::Scene scene;
    render::Camera camera;
    render::Settings settings;
};

/// Two lamps with soft edges over a floor, one with a gobo and a ball in its light; uneven haze, lenses,
/// bloom. Gives its meshes and its gobo to `assets`.
FeatureScene makeFullScene(render::AssetSink& assets);

struct Removal {
    std::string name;  ///< What is taken away: "haze", "noise", ...
    std::string part;  ///< The FramePart that is then not needed; empty: none, there is only less of all.
    std::function<void(FeatureScene&)> apply;
};

const std::vector<Removal>& removals();

}  // namespace hazer::test
