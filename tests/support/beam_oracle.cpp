#include "tests/support/beam_oracle.h"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <vector>

namespace hazer::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

double henyeyGreenstein(double cosTheta, double g) {
    return (1.0 - g * g) / (4.0 * kPi * std::pow(1.0 + g * g - 2.0 * g * cosTheta, 1.5));
}

/// Everything at one point of the ray; 0 outside the beam.
double integrand(const OracleBeam& beam, const OracleHaze& haze, const glm::dvec3& eye,
                 const glm::dvec3& direction, double t) {
    const glm::dvec3 point = eye + t * direction;
    const double r = glm::length(point);
    const double axial = -point.z;
    if (axial < beam.apexToLensM || axial <= 0.0) return 0.0;
    const double psi = std::atan2(std::hypot(point.x, point.y), axial);
    if (psi > beam.cutHalfAngleRad) return 0.0;
    double intensity = 1.0;
    if (beam.exponent > 0.0) {
        const double gauss = std::exp(-std::log(2.0) * std::pow(psi / beam.beamHalfAngleRad, beam.exponent));
        intensity = std::max((gauss - beam.profileCut) / (1.0 - beam.profileCut), 0.0);
    }
    // The light starts at the lens, a share of the way from the apex.
    const double lensToPoint = r * (1.0 - beam.apexToLensM / axial);
    const double cosTheta = glm::dot(point / r, -direction);
    const double phase = haze.forwardWeight * henyeyGreenstein(cosTheta, haze.forwardG) +
                         (1.0 - haze.forwardWeight) * henyeyGreenstein(cosTheta, haze.backwardG);
    return haze.scatteringPerM * phase * intensity / (r * r) *
           std::exp(-haze.extinctionPerM * (t + lensToPoint));
}

/// Where the ray may enter or leave the beam: both nappes of the cone (the textbook quadratic, in extended
/// precision), and the lens plane.
std::vector<double> breaks(const OracleBeam& beam, const glm::dvec3& eye, const glm::dvec3& direction,
                           double endM) {
    std::vector<double> t{0.0, endM};
    using Wide = long double;
    const Wide tan2 = std::pow(std::tan(static_cast<Wide>(beam.cutHalfAngleRad)), 2);
    const Wide ex = eye.x, ey = eye.y, ez = eye.z, dx = direction.x, dy = direction.y, dz = direction.z;
    const Wide a = dx * dx + dy * dy - tan2 * dz * dz;
    const Wide b = ex * dx + ey * dy - tan2 * ez * dz;
    const Wide c = ex * ex + ey * ey - tan2 * ez * ez;
    const Wide discriminant = b * b - a * c;
    if (discriminant > 0) {
        const Wide q = -(b + (b >= 0 ? 1 : -1) * std::sqrt(discriminant));
        if (a != 0) t.push_back(static_cast<double>(q / a));
        if (q != 0) t.push_back(static_cast<double>(c / q));
    }
    if (direction.z != 0.0) t.push_back((-beam.apexToLensM - eye.z) / direction.z);
    // The closest point to the apex, where the integrand is steepest.
    t.push_back(-glm::dot(eye, direction));
    for (double& value : t) value = std::clamp(value, 0.0, endM);
    std::sort(t.begin(), t.end());
    return t;
}

}  // namespace

double oracleRadiance(const OracleBeam& beam, const OracleHaze& haze, const glm::dvec3& eye,
                      const glm::dvec3& direction, double endM) {
    const std::vector<double> t = breaks(beam, eye, direction, endM);
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < t.size(); ++i) {
        const double width = t[i + 1] - t[i];
        if (width <= 0.0 || integrand(beam, haze, eye, direction, t[i] + 0.5 * width) == 0.0) continue;
        const auto f = [&](double at) { return integrand(beam, haze, eye, direction, at); };
        sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(f, t[i], t[i + 1], 12, 1e-9);
    }
    return sum;
}

}  // namespace hazer::test
