// The bare lights of a show as beams of the renderer.
#pragma once

#include <vector>

#include "app/show.h"
#include "render/asset_sink.h"
#include "render/scene.h"

namespace hazer::app {

/// One beam for each light, in the show's order. Gives their gobos and webs to `assets`, each file once; what
/// is not drawn of a web is logged. Throws ShowError if a file cannot be read.
std::vector<render::Beam> lightBeams(const Show& show, render::AssetSink& assets);

}  // namespace hazer::app
