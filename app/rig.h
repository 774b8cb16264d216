// The bridge from fixtures to light: what a fixture does becomes what the renderer draws. The only such
// translation.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "fixtures/fixture.h"
#include "render/asset_sink.h"
#include "render/scene.h"

namespace hazer::app {

/// The beam of light that a Beam geometry sends out, with nothing in its way. Empty if it is dark.
std::optional<render::Beam> beamFromState(const fixtures::BeamState& state);

/// Where a gobo is sharp [m from the lens] for Focus1 0..1: from 2 m (0, near), even in dioptres, to 1 km (1,
/// far).
double focusDistanceM(double focus);

/// Turns fixture states into beams and bodies. Holds the gobos and meshes that it has given to `assets`,
/// each once. They must outlive it.
class Rig {
 public:
    explicit Rig(render::AssetSink& assets);

    /// Adds a fixture's beams and body to the scene.
    void append(const fixtures::FixtureState& state, render::Scene& scene);

 private:
    /// The surfaces of one paint, scaled to edges of 1.
    struct BodyPart {
        render::MeshId mesh = -1;
        render::Material material;
    };

    void appendPart(const fixtures::PartState& part, render::Scene& scene);
    render::GoboId goboFor(const std::shared_ptr<const fixtures::WheelImage>& image);
    const std::vector<BodyPart>& partsOf(const std::shared_ptr<const fixtures::ModelFile>& file);
    std::vector<BodyPart> readBody(const fixtures::ModelFile& file);
    render::MeshId meshFor(fixtures::PrimitiveType primitive);

    render::AssetSink& assets_;
    std::map<std::shared_ptr<const fixtures::WheelImage>, render::GoboId> gobos_;
    std::map<fixtures::PrimitiveType, render::MeshId> meshes_;
    /// Of files; none of those that cannot be drawn.
    std::map<std::shared_ptr<const fixtures::ModelFile>, std::vector<BodyPart>> bodies_;
    std::size_t bodyVertices_ = 0;  ///< Of all files together.
};

}  // namespace hazer::app
