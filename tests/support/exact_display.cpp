#include "tests/support/exact_display.h"

#include <algorithm>
#include <cmath>

namespace hazer::test {
namespace {

// Rows as published; glm takes columns.
const glm::dmat3 kInset = glm::transpose(
    glm::dmat3(0.856627, 0.0951212, 0.0482516, 0.137319, 0.761242, 0.101439, 0.111898, 0.0767994, 0.811302));
const glm::dmat3 kOutset = glm::transpose(
    glm::dmat3(1.1271, -0.110607, -0.0164939, -0.14133, 1.157824, -0.0164939, -0.14133, -0.110607, 1.251936));
const glm::dmat3 kRec709FromRec2020 = glm::transpose(glm::dmat3(
    1.660491, -0.587641, -0.072850, -0.124550, 1.132900, -0.008349, -0.018151, -0.100579, 1.118730));

double agxCurve(double light) {
    constexpr double kDarkest = -12.47393;
    constexpr double kBrightest = 4.026069;
    const double stops = std::log2(std::max(light, 1e-10));
    const double x = std::clamp((stops - kDarkest) / (kBrightest - kDarkest), 0.0, 1.0);
    return 15.5 * std::pow(x, 6) - 40.14 * std::pow(x, 5) + 31.96 * std::pow(x, 4) - 6.868 * std::pow(x, 3) +
           0.4298 * x * x + 0.1191 * x - 0.00232;
}

double encodeSrgb(double linear) {
    const double c = std::clamp(linear, 0.0, 1.0);
    return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
}

template <typename Function>
glm::dvec3 each(const glm::dvec3& v, Function function) {
    return {function(v.r), function(v.g), function(v.b)};
}

}  // namespace

glm::dvec3 exactDisplay(const glm::dvec3& rec2020) {
    const glm::dvec3 curve = kOutset * each(kInset * rec2020, agxCurve);
    const glm::dvec3 linear = each(curve, [](double v) { return std::pow(std::max(v, 0.0), 2.2); });
    return each(kRec709FromRec2020 * linear, encodeSrgb);
}

glm::dvec3 rec2020FromRec709(const glm::dvec3& rec709) {
    return glm::inverse(kRec709FromRec2020) * rec709;
}

double sensorScale(double exposureEv100) {
    return 1.0 / (1.2 * std::exp2(exposureEv100));
}

}  // namespace hazer::test
