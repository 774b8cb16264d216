// Reads binary glTF 2.0 meshes, as GDTF and MVR have them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/mesh_surface.h"

namespace hazer::render {

/// The triangles of the file's scene, a surface for each primitive of each node, with Z up. Only its own
/// buffer is read; extensions that it requires, and sparse accessors, are refused. Throws RenderError.
std::vector<MeshSurface> readGlb(std::span<const std::uint8_t> bytes);

}  // namespace hazer::render
