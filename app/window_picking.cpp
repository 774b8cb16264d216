#include "app/window_picking.h"

#include "render/camera.h"

namespace hazer::app {

std::optional<glm::dvec2> placeInPicture(const render::Camera& camera, const glm::dvec2& size,
                                         const glm::dvec3& pointM) {
    const glm::dvec3 inView = glm::transpose(render::worldFromView(camera)) * (pointM - camera.positionM);
    if (inView.z >= 0.0) return std::nullopt;
    const glm::dvec2 tangent = glm::dvec2(inView) / -inView.z / render::viewTangent(camera, size.x / size.y);
    return size * (glm::dvec2(0.5) + glm::dvec2(0.5, -0.5) * tangent);
}

std::optional<std::size_t> pointAt(const render::Camera& camera, const glm::dvec2& size,
                                   const glm::dvec2& place, double reach,
                                   std::span<const glm::dvec3> pointsM) {
    std::optional<std::size_t> nearest;
    for (std::size_t i = 0; i < pointsM.size(); ++i) {
        const std::optional<glm::dvec2> shown = placeInPicture(camera, size, pointsM[i]);
        if (!shown || glm::distance(*shown, place) > reach) continue;
        reach = glm::distance(*shown, place);
        nearest = i;
    }
    return nearest;
}

}  // namespace hazer::app
