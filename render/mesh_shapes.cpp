// The plain bodies.
#include <array>
#include <glm/gtc/constants.hpp>

#include "render/mesh.h"
#include "render/mesh_builder.h"

namespace hazer::render {
namespace {

constexpr int kCylinderSegments = 48;
constexpr int kSphereColumns = 32;
constexpr int kSphereRows = 16;

/// Square of edge 1 about `center`, spanned by two orthogonal unit vectors.
void appendSquare(Mesh& mesh, glm::vec3 center, glm::vec3 right, glm::vec3 up) {
    appendSurface(mesh, 1, 1, [&](float u, float v) {
        return Vertex{center + (u - 0.5f) * right + (v - 0.5f) * up, glm::cross(right, up)};
    });
}

}  // namespace

Mesh makeBox() {
    const std::array<glm::vec3, 3> axes{glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)};
    Mesh mesh;
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
        const glm::vec3 right = axes[(axis + 1) % 3];
        const glm::vec3 up = axes[(axis + 2) % 3];
        appendSquare(mesh, 0.5f * axes[axis], right, up);
        appendSquare(mesh, -0.5f * axes[axis], up, right);
    }
    return mesh;
}

Mesh makeCylinder() {
    Mesh mesh;
    appendBar(mesh, {0, 0, -0.5f}, {0, 0, 0.5f}, 0.5f, kCylinderSegments);
    return mesh;
}

Mesh makeSphere() {
    Mesh mesh;
    appendSurface(mesh, kSphereColumns, kSphereRows, [](float u, float v) {
        const float azimuthRad = u * glm::two_pi<float>();
        const float polarRad = (1.0f - v) * glm::pi<float>();
        const glm::vec3 direction(std::sin(polarRad) * std::cos(azimuthRad),
                                  std::sin(polarRad) * std::sin(azimuthRad), std::cos(polarRad));
        return Vertex{0.5f * direction, direction};
    });
    return mesh;
}

Mesh makePlane() {
    Mesh mesh;
    appendSquare(mesh, glm::vec3(0), {1, 0, 0}, {0, 1, 0});
    return mesh;
}

}  // namespace hazer::render
