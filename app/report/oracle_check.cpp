#include "app/report/oracle_check.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "app/light_color.h"
#include "render/gobo_store.h"
#include "render/oracle/scene_oracle.h"

namespace hazer::app {
namespace {

using render::oracle::SceneOracle;

/// Copies of the meshes, gobos and webs that the scene uses, under the renderer's own handles.
render::oracle::Library libraryOf(const render::Scene& scene, const render::Renderer& renderer) {
    render::oracle::Library library;
    int meshes = 0, gobos = 0, webs = 0;
    for (const auto& instance : scene.instances) meshes = std::max(meshes, instance.mesh + 1);
    for (const auto& beam : scene.beams) {
        gobos = std::max(gobos, beam.gobo + 1);
        webs = std::max(webs, beam.web + 1);
    }
    for (int mesh = 0; mesh < meshes; ++mesh) library.meshes.push_back(renderer.readMesh(mesh));
    for (int gobo = 0; gobo < gobos; ++gobo) {
        library.gobos.emplace_back(renderer.readGobo(gobo), render::kGoboSize);
    }
    library.density = render::oracle::hazeDensity(scene.haze, scene.timeS);
    for (int web = 0; web < webs; ++web) library.webs.push_back(renderer.readWeb(web));
    return library;
}

/// One row of pixels, for pictureError().
void append(const glm::vec3& light, render::FloatImage& row) {
    row.rgb.insert(row.rgb.end(), {light.r, light.g, light.b});
    row.height = 1;
    ++row.width;
}

/// The picture's own light as the renderer has it inside.
render::Color lightAt(const render::FloatImage& picture, std::size_t pixel) {
    const float* rgb = &picture.rgb[3 * pixel];
    return rec2020FromRec709(glm::dvec3(rgb[0], rgb[1], rgb[2]));
}

}  // namespace

OracleResult checkAgainstOracle(const render::FloatImage& picture, const render::Scene& scene,
                                const render::Camera& camera, const render::Renderer& renderer, int pixels) {
    std::vector<std::size_t> lit = litPixels(picture);
    std::shuffle(lit.begin(), lit.end(), std::mt19937(1));
    const SceneOracle oracle(scene, camera, picture.width, picture.height, libraryOf(scene, renderer));
    OracleCheck check;
    render::FloatImage drawn, expected;
    for (const std::size_t pixel : lit) {
        if (drawn.width == pixels) break;
        const double x = static_cast<double>(pixel % static_cast<std::size_t>(picture.width)) + 0.5;
        const double y = static_cast<double>(pixel / static_cast<std::size_t>(picture.width)) + 0.5;
        if (!oracle.isClearOfOutlines(x, y)) {
            ++check.outlines;
            continue;
        }
        append(lightAt(picture, pixel), drawn);
        append(glm::vec3(oracle.air(x, y) + oracle.surface(x, y)), expected);
    }
    const PictureError error = pictureError(drawn, expected);
    check.pixels = error.litPixels;
    check.rmsRel = error.rmsRel;
    check.maxRel = error.maxRel;
    return {check, {}};
}

}  // namespace hazer::app
