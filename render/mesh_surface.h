// What the readers of mesh files share: triangles as a file has them, before they are drawn.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "render/error.h"
#include "render/mesh.h"

namespace hazer::render {

/// What a stranger's mesh may have: nothing that comes with a rig is as detailed.
inline constexpr std::size_t kMaxRigVertices = 1'000'000;
inline constexpr std::size_t kMaxRigTriangles = 1'000'000;

struct MeshSurface {
    std::vector<glm::vec3> positionsM;
    std::vector<glm::vec3> normals;                       ///< One a position, of any length; or none.
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Into positionsM.
    std::optional<glm::vec3> paint;                       ///< As PaintedMesh::paint.
};

/// Counts what is about to be read of a file. Throws RenderError where that is too much.
class MeshBudget {
 public:
    void spend(std::size_t vertices, std::size_t triangles) {
        vertices_ += vertices;
        triangles_ += triangles;
        if (vertices_ > kMaxRigVertices || triangles_ > kMaxRigTriangles)
            throw RenderError("it has more than a million vertices or triangles; simplify it");
    }

 private:
    std::size_t vertices_ = 0;
    std::size_t triangles_ = 0;
};

/// Appends a surface to what is drawn. Without normals of its own it gets them: edges of more than 50 degrees
/// stay edges. Triangles without area are left out. Time is linear but for sorting, whatever the surface.
void appendSurface(const MeshSurface& surface, Mesh& mesh);

}  // namespace hazer::render
