// Reads Autodesk 3DS meshes, as GDTF and MVR have them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/mesh_surface.h"

namespace hazer::render {

/// One surface an object and material, where the file places them; from millimetres to metres. Throws
/// RenderError.
std::vector<MeshSurface> read3ds(std::span<const std::uint8_t> bytes);

}  // namespace hazer::render
