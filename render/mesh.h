// Triangle meshes, and the shapes that come with hazer.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <vector>

namespace hazer::render {

struct Vertex {
    glm::vec3 positionM;
    glm::vec3 normal;  ///< Unit length.
};

/// Counter-clockwise triangles seen from outside. Z is up.
struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
};

/// Sphere around all vertices: centre, and radius [m].
struct BoundingSphere {
    glm::vec3 centerM{0.0f};
    float radiusM = 0.0f;
};
BoundingSphere boundingSphere(const Mesh& mesh);

/// Box along the axes around all vertices.
struct BoundingBox {
    glm::vec3 lowM{0.0f};
    glm::vec3 highM{0.0f};
};
BoundingBox boundingBox(const Mesh& mesh);

/// Both enclose the mesh; what is outside of either is outside of it.
struct MeshBounds {
    BoundingSphere sphere;
    BoundingBox box;
};

/// Shapes that come with hazer. Unit sizes are meant to be scaled by the instance.
Mesh makeBox();       ///< Edge 1, centred.
Mesh makeCylinder();  ///< Diameter 1, height 1, along Z, centred.
Mesh makeSphere();    ///< Diameter 1, centred.
Mesh makePlane();     ///< 1 x 1 in the XY plane, normal +Z, centred.
Mesh makeTeapot();    ///< Utah teapot, 1 m high, standing on z = 0, spout towards +X.
Mesh makePerson();    ///< A standing figure 1.75 m high, feet on z = 0, facing -Y.
/// Box truss of `lengthM` along X, centred: four chords and lacing, `widthM` wide and high.
Mesh makeTruss(double lengthM, double widthM);

/// Reads glTF, 3DS or another format that Assimp knows; glTF's Y-up becomes Z-up. Throws RenderError.
Mesh loadMesh(const std::filesystem::path& file);

}  // namespace hazer::render
