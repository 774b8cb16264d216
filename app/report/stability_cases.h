// Scenes that are hard to integrate, by name.
#pragma once

#include <string>
#include <vector>

#include "render/mesh.h"
#include "render/scene.h"

namespace hazer::app {

/// What a case must show besides numbers.
enum class Expectation {
    kAnything,  ///< Numbers, none below 0.
    kLight,     ///< Some light.
    kDark,      ///< None at all.
    kShaded,    ///< Nowhere more than a twentieth of the brightest light without bodies.
    kOracle,    ///< Pixels as the oracle says.
};

/// A scene without lenses. Meshes are those of stabilityMeshes(), by index.
struct StabilityCase {
    std::string name;
    render::Scene scene;
    render::Camera camera;
    Expectation expectation = Expectation::kOracle;
};

/// At least forty cases; names are unique.
std::vector<StabilityCase> stabilityCases();

/// A box and a plane of edge 1.
std::vector<render::Mesh> stabilityMeshes();

/// Lights and haze whose numbers are out of range or no numbers, as text of a show; all must be refused.
struct RefusedShow {
    std::string name;
    std::string text;
};
std::vector<RefusedShow> refusedShows();

}  // namespace hazer::app
