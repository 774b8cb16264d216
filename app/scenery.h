// The scene objects of a rig as meshes.
#pragma once

#include <string>
#include <vector>

#include "app/set_dressing.h"
#include "app/show.h"

namespace hazer::app {

/// Appends the scenery's meshes to `dressing`, and gives each file to `assets` once. A file that is missing,
/// broken or too large is left out, with a sentence for each. Throws ShowError if the archive cannot be read.
std::vector<std::string> appendScenery(const ShowScenery& scenery, render::AssetSink& assets,
                                       SetDressing& dressing);

}  // namespace hazer::app
