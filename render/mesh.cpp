#include "render/mesh.h"

#include <algorithm>

namespace hazer::render {

BoundingBox boundingBox(const Mesh& mesh) {
    if (mesh.vertices.empty()) return {};
    BoundingBox box{mesh.vertices.front().positionM, mesh.vertices.front().positionM};
    for (const Vertex& vertex : mesh.vertices) {
        box.lowM = glm::min(box.lowM, vertex.positionM);
        box.highM = glm::max(box.highM, vertex.positionM);
    }
    return box;
}

BoundingSphere boundingSphere(const Mesh& mesh) {
    const BoundingBox box = boundingBox(mesh);
    // The middle of the box is at most a factor sqrt(3) from the tightest sphere, and good enough to cull by.
    BoundingSphere sphere{0.5f * (box.lowM + box.highM), 0.0f};
    for (const Vertex& vertex : mesh.vertices) {
        sphere.radiusM = std::max(sphere.radiusM, glm::distance(sphere.centerM, vertex.positionM));
    }
    return sphere;
}

}  // namespace hazer::render
