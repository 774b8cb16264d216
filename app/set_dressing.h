// The objects of a show as meshes: floor, walls, decks, trusses, people, models.
#pragma once

#include <vector>

#include "app/show.h"
#include "render/asset_sink.h"
#include "render/scene.h"

namespace hazer::app {

/// An object whose mesh has been given away.
struct DressedObject {
    render::MeshInstance instance;
    bool isFurther = false;
};

/// All objects of a show, in the show's order.
using SetDressing = std::vector<DressedObject>;

/// Gives the objects' meshes to `assets`; objects of the same shape share one. Throws ShowError if a
/// model cannot be read.
SetDressing dressSet(const Show& show, render::AssetSink& assets);

/// Where the mesh of an object stands: the pose as written, then the shape's own anchor and size.
glm::dmat4 worldFromMesh(const ShowObject& object);

}  // namespace hazer::app
