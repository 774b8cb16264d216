// What the shapes that come with hazer are put together from.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>

#include "render/mesh.h"

namespace hazer::render {

/// A piece of surface over u and v in 0..1. Its outside is where dP/du x dP/dv points.
using Surface = std::function<Vertex(float u, float v)>;

/// Appends `surface` as a net of columns x rows quads; what collapses to a line at a pole is left out.
void appendSurface(Mesh& mesh, int columns, int rows, const Surface& surface);

/// A point of a profile that is turned about the Z axis: distance from the axis, and height [m].
struct ProfilePoint {
    float radiusM;
    float heightM;
};

/// Appends what the straight line between two profile points sweeps: disc, cylinder, cone. The outside lies
/// to the right of the way from `from` to `to` (axis to the left), so that a profile runs from the lowest
/// point outwards and up.
void appendConeBand(Mesh& mesh, ProfilePoint from, ProfilePoint to, int segments);

/// Appends a closed round bar between two points that are not the same.
void appendBar(Mesh& mesh, glm::vec3 fromM, glm::vec3 toM, float radiusM, int segments);

/// Appends `part`, moved by a transform that does not mirror.
void appendTransformed(Mesh& mesh, const Mesh& part, const glm::mat4& meshFromPart);

/// Vertices so far, as an index: that of the next one.
inline std::uint32_t vertexCount(const Mesh& mesh) {
    return static_cast<std::uint32_t>(mesh.vertices.size());
}

/// Adds a triangle unless two of its corners are in the same place.
void appendTriangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c);

}  // namespace hazer::render
