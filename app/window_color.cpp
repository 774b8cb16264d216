#include "app/window_color.h"

#include <algorithm>
#include <glm/gtc/color_space.hpp>

#include "app/light_color.h"
#include "fixtures/color.h"

namespace hazer::app {
namespace {

/// Columns are the Rec. 709 primaries in Rec. 2020.
glm::dmat3 rec2020FromRec709Matrix() {
    return {glm::dvec3(rec2020FromRec709({1.0, 0.0, 0.0})), glm::dvec3(rec2020FromRec709({0.0, 1.0, 0.0})),
            glm::dvec3(rec2020FromRec709({0.0, 0.0, 1.0}))};
}

glm::vec3 encoded(const glm::dvec3& rec709) {
    return glm::convertLinearToSRGB(glm::clamp(glm::vec3(rec709), 0.0f, 1.0f));
}

}  // namespace

glm::vec3 srgbFromRec2020(const render::Color& color) {
    static const glm::dmat3 rec709FromRec2020 = glm::inverse(rec2020FromRec709Matrix());
    return encoded(rec709FromRec2020 * glm::dvec3(color));
}

render::Color rec2020FromSrgb(const glm::vec3& srgb) {
    return rec2020FromRec709(glm::dvec3(glm::convertSRGBToLinear(srgb)));
}

glm::vec3 swatchOf(const fixtures::ColorCie& color) {
    const render::Color light = lightColorFromXyz(fixtures::xyzFromCie(color));
    const float strongest = std::max({light.r, light.g, light.b});
    return strongest > 0.0f ? srgbFromRec2020(light / strongest) : glm::vec3(0.0f);
}

}  // namespace hazer::app
