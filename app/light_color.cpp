#include "app/light_color.h"

#include <algorithm>

namespace hazer::app {
namespace {

// glm is column-major: rows are written as columns and transposed.
const glm::dmat3 kRec2020FromXyz = glm::transpose(glm::dmat3(1.7166512, -0.3556708, -0.2533663,  //
                                                             -0.6666844, 1.6164812, 0.0157685,   //
                                                             0.0176399, -0.0427706, 0.9421031));
const glm::dmat3 kRec2020FromRec709 = glm::transpose(glm::dmat3(0.6274039, 0.3292830, 0.0433131,  //
                                                                0.0690973, 0.9195404, 0.0113623,  //
                                                                0.0163914, 0.0880133, 0.8955953));

}  // namespace

double luminance(const glm::dvec3& rec2020) {
    return glm::dot(rec2020, glm::dvec3(0.2627, 0.6780, 0.0593));
}

render::Color rec2020FromRec709(const glm::dvec3& rec709) {
    return render::Color(kRec2020FromRec709 * rec709);
}

glm::dvec3 rec2020FromXyz(const glm::dvec3& xyz) {
    return kRec2020FromXyz * xyz;
}

render::Color lightColorFromXyz(const glm::dvec3& xyz) {
    const glm::dvec3 rgb = rec2020FromXyz(xyz);
    const double light = luminance(rgb);
    if (!(light > 0.0)) return render::Color(0.0f);
    const glm::dvec3 color = rgb / light;
    const double lowest = std::min({color.r, color.g, color.b});
    if (lowest >= 0.0) return render::Color(color);
    // White of luminance 1 is (1, 1, 1); on the way to it the lowest component reaches 0 first here.
    const double towardsWhite = -lowest / (1.0 - lowest);
    return render::Color(glm::mix(color, glm::dvec3(1.0), towardsWhite));
}

}  // namespace hazer::app
