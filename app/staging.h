// Everything of a show that is drawn: its fixtures, bare lights and objects put together as one scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/patch.h"
#include "app/rig.h"
#include "app/set_dressing.h"
#include "app/show.h"
#include "render/asset_sink.h"
#include "render/scene.h"

namespace hazer::app {

/// What a person may change while the show runs. It starts as the show file says.
struct SceneControls {
    render::Haze haze;
    render::Ambient ambient;
    render::Color backgroundCdPerM2{0.0f};
    std::optional<float> specular;   ///< 0..1 for every object; empty: each has its own.
    std::optional<float> shininess;  ///< 1..1000 for every object; empty: each has its own.
    bool furtherObjects = true;      ///< Draw the objects that the show marks as further ones.
};

SceneControls controlsOf(const Show& show);

/// Holds what a show has given to `assets`, which must outlive it.
class Staging {
 public:
    /// Gives the meshes of the show's objects and the gobos of its bare lights to `assets`; those of its
    /// fixtures follow as they are used. Throws ShowError if a file cannot be read.
    Staging(const Show& show, render::AssetSink& assets);

    /// About scene objects of the show's rig that are left out.
    const std::vector<std::string>& warnings() const { return warnings_; }

    /// The show at `timeS` with its fixtures as they stand: bare lights first, then the beams of the
    /// fixtures in the order of the patch, dark ones left out.
    render::Scene scene(const Patch& patch, const SceneControls& controls, double timeS);

 private:
    Rig rig_;
    SetDressing dressing_;
    std::vector<std::string> warnings_;
    std::vector<render::Beam> lights_;  ///< Those that no fixture carries.
    fixtures::FixtureState state_;  ///< Of one fixture after the other; kept so that frames allocate less.
};

/// Logs what was read over in the show's rig: ten sentences at most, and one that says how many more there
/// are.
void warnAboutRig(const Show& show, const Staging& staging);

}  // namespace hazer::app
