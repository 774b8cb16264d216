// A mesh that comes with a rig may be any bytes: it becomes triangles at finite places, or a RenderError and
// nothing else.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "render/error.h"
#include "render/rig_mesh.h"

namespace {

using namespace hazer::render;

void require(bool holds) {
    if (!holds) std::abort();
}

void check(const PaintedMesh& painted) {
    require(!painted.mesh.indices.empty() && painted.mesh.indices.size() % 3 == 0);
    for (const std::uint32_t index : painted.mesh.indices) require(index < painted.mesh.vertices.size());
    for (const Vertex& vertex : painted.mesh.vertices) {
        require(std::isfinite(vertex.positionM.x + vertex.positionM.y + vertex.positionM.z));
        require(std::abs(glm::length(vertex.normal) - 1.0f) < 1e-3f);
    }
    if (!painted.paint) return;
    for (int i = 0; i < 3; ++i) require((*painted.paint)[i] >= 0.0f && (*painted.paint)[i] <= 1.0f);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const bool isGltf = size > 0 && data[0] == 'g';
    try {
        for (const PaintedMesh& painted : parseRigMesh({data, size}, isGltf ? "fuzz.glb" : "fuzz.3ds"))
            check(painted);
    } catch (const RenderError&) {
        // The answer to a broken file.
    }
    return 0;
}
