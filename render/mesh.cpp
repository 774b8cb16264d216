#include "render/mesh.h"

#include <algorithm>

namespace hazer::render {

BoundingSphere boundingSphere(const Mesh& mesh) {
    if (mesh.vertices.empty()) return {};
    glm::vec3 lowM = mesh.vertices.front().positionM;
    glm::vec3 highM = lowM;
    for (const Vertex& vertex : mesh.vertices) {
        lowM = glm::min(lowM, vertex.positionM);
        highM = glm::max(highM, vertex.positionM);
    }
    // The middle of the box is at most a factor sqrt(3) from the tightest sphere, and good enough to cull by.
    BoundingSphere sphere{0.5f * (lowM + highM), 0.0f};
    for (const Vertex& vertex : mesh.vertices) {
        sphere.radiusM = std::max(sphere.radiusM, glm::distance(sphere.centerM, vertex.positionM));
    }
    return sphere;
}

}  // namespace hazer::render
