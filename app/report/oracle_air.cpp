#include "app/report/oracle_air.h"

#include "render/oracle/scene_oracle.h"

namespace hazer::app {

std::vector<double> oracleAir(const render::Scene& scene, const render::Camera& camera, int size,
                              const std::vector<render::Mesh>& meshes,
                              const std::vector<glm::ivec2>& pixels) {
    render::oracle::Library library;
    library.meshes = meshes;
    const render::oracle::SceneOracle oracle(scene, camera, size, size, std::move(library));
    std::vector<double> light;
    for (const glm::ivec2& pixel : pixels) {
        const glm::dvec2 center = glm::dvec2(pixel) + 0.5;
        const bool isClear = oracle.isClearOfOutlines(center.x, center.y);
        const glm::dvec3 color = isClear ? oracle.air(center.x, center.y) : glm::dvec3(-1.0);
        light.push_back(color.x + color.y + color.z);
    }
    return light;
}

}  // namespace hazer::app
