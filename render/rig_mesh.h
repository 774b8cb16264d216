// Meshes that come with rigs and fixtures, from strangers: 3DS and binary glTF (.glb).
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/mesh.h"

namespace hazer::render {

/// The surfaces of a mesh that have one paint.
struct PaintedMesh {
    Mesh mesh;
    std::optional<glm::vec3> paint;  ///< Linear Rec. 709, 0..1; empty: the file does not say.
};

/// Reads a 3DS or a binary glTF, as its name ends, in metres and with Z up: 3DS is written in millimetres,
/// glTF in metres with Y up. What they refer to is not read, nor are textures, bones and keyframes. Never
/// empty; at most four paints, further ones become the first. Bounds: 1 million triangles and vertices each,
/// 2 MiB of JSON. Pure. `name` is in messages, too. Throws RenderError.
std::vector<PaintedMesh> parseRigMesh(std::span<const std::uint8_t> bytes, const std::string& name);

}  // namespace hazer::render
