#include "app/paint.h"

#include "app/light_color.h"

namespace hazer::app {

render::Material materialOf(const std::optional<glm::vec3>& paint, const render::Color& otherwise) {
    constexpr float kWhitestPaint = 0.8f;
    render::Material material;
    material.albedo = paint ? kWhitestPaint * rec2020FromRec709(*paint) : otherwise;
    return material;
}

}  // namespace hazer::app
