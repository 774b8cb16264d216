#include "render/oracle/single_beam.h"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

namespace hazer::render::oracle {
namespace {

constexpr double kPi = 3.14159265358979323846;

double henyeyGreenstein(double cosTheta, double g) {
    return (1.0 - g * g) / (4.0 * kPi * std::pow(1.0 + g * g - 2.0 * g * cosTheta, 1.5));
}

/// Light scattered at one point of the ray [cd/m^3]; 0 outside the beam.
double integrand(const BeamModel& beam, const HazeModel& haze, const Ray& ray, double t) {
    const glm::dvec3 point = ray.originM + t * ray.direction;
    const double intensity = intensityTowards(beam, point);
    if (intensity == 0.0) return 0.0;
    const double r = glm::length(point);
    return haze.scatteringPerM * phase(haze, glm::dot(point / r, -ray.direction)) * intensity / (r * r) *
           std::exp(-haze.extinctionPerM * (t + wayFromLensM(beam, point)));
}

/// Where the ray meets the cone or its mirror image: the textbook quadratic, in extended precision.
void appendConeCrossings(const BeamModel& beam, const Ray& ray, std::vector<double>& t) {
    using Wide = long double;
    const Wide sine = std::sin(static_cast<Wide>(beam.cutHalfAngleRad));
    const Wide cosine = std::cos(static_cast<Wide>(beam.cutHalfAngleRad));
    const Wide s2 = sine * sine, c2 = cosine * cosine;
    const glm::vec<3, Wide> o(ray.originM), d(ray.direction);
    const Wide a = c2 * (d.x * d.x + d.y * d.y) - s2 * d.z * d.z;
    const Wide b = c2 * (o.x * d.x + o.y * d.y) - s2 * o.z * d.z;
    const Wide c = c2 * (o.x * o.x + o.y * o.y) - s2 * o.z * o.z;
    const Wide discriminant = b * b - a * c;
    if (discriminant <= 0) return;
    const Wide q = -(b + (b >= 0 ? 1 : -1) * std::sqrt(discriminant));
    if (a != 0) t.push_back(static_cast<double>(q / a));
    if (q != 0) t.push_back(static_cast<double>(c / q));
}

/// The integrand is a peak as wide as the ray's distance from the apex, with long tails.
void appendAroundClosest(const Ray& ray, std::vector<double>& t) {
    const double closest = -glm::dot(ray.originM, ray.direction);
    const double distance = glm::length(ray.originM + closest * ray.direction);
    t.push_back(closest);
    if (distance <= 0.0) return;
    for (double away = 0.5 * distance; away < ray.endM + std::abs(closest); away *= 4.0) {
        t.push_back(closest - away);
        t.push_back(closest + away);
    }
}

double integrate(const std::function<double(double)>& f, const Stretch& stretch, unsigned halvings,
                 double tolerance) {
    return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(f, stretch.fromM, stretch.toM,
                                                                         halvings, tolerance);
}

}  // namespace

double phase(const HazeModel& haze, double cosTheta) {
    return haze.forwardWeight * henyeyGreenstein(cosTheta, haze.forwardG) +
           (1.0 - haze.forwardWeight) * henyeyGreenstein(cosTheta, haze.backwardG);
}

double intensityTowards(const BeamModel& beam, const glm::dvec3& pointM) {
    const double axialM = -pointM.z;
    if (beam.apexToLensM > 0.0 && axialM < beam.apexToLensM) return 0.0;
    const double psi = std::atan2(std::hypot(pointM.x, pointM.y), axialM);
    if (psi > beam.cutHalfAngleRad) return 0.0;
    if (beam.web) return beam.web(pointM / glm::length(pointM));
    if (beam.exponent <= 0.0) return 1.0;
    const double gauss = std::exp(-std::log(2.0) * std::pow(psi / beam.beamHalfAngleRad, beam.exponent));
    return std::max((gauss - beam.profileCut) / (1.0 - beam.profileCut), 0.0);
}

double wayFromLensM(const BeamModel& beam, const glm::dvec3& pointM) {
    // The light starts at the lens, a share of the way from the apex.
    const double share = beam.apexToLensM > 0.0 ? beam.apexToLensM / -pointM.z : 0.0;
    return glm::length(pointM) * (1.0 - share);
}

std::vector<Stretch> smoothStretches(const BeamModel& beam, const Ray& ray) {
    std::vector<double> t{0.0, ray.endM};
    appendConeCrossings(beam, ray, t);
    if (ray.direction.z != 0.0) t.push_back((-beam.apexToLensM - ray.originM.z) / ray.direction.z);
    appendAroundClosest(ray, t);
    for (double& value : t) value = std::clamp(value, 0.0, ray.endM);
    std::sort(t.begin(), t.end());
    std::vector<Stretch> stretches;
    for (std::size_t i = 0; i + 1 < t.size(); ++i) {
        if (t[i + 1] <= t[i]) continue;
        const glm::dvec3 middle = ray.originM + 0.5 * (t[i] + t[i + 1]) * ray.direction;
        if (intensityTowards(beam, middle) > 0.0) stretches.push_back({t[i], t[i + 1]});
    }
    return stretches;
}

std::vector<Stretch> splitByAngle(const Ray& ray, const Stretch& stretch, int count) {
    const double closest = -glm::dot(ray.originM, ray.direction);
    const double distance = glm::length(ray.originM + closest * ray.direction);
    const double from = std::atan2(stretch.fromM - closest, distance);
    const double step = (std::atan2(stretch.toM - closest, distance) - from) / count;
    std::vector<Stretch> parts;
    double at = stretch.fromM;
    for (int i = 1; i <= count; ++i) {
        const double even = closest + distance * std::tan(from + i * step);
        const double to = i == count ? stretch.toM : std::clamp(even, at, stretch.toM);
        if (to > at) parts.push_back({at, to});
        at = to;
    }
    return parts;
}

double airRadiance(const BeamModel& beam, const HazeModel& haze, const Ray& ray) {
    double sum = 0.0;
    for (const Stretch& stretch : smoothStretches(beam, ray)) {
        sum += integrate([&](double t) { return integrand(beam, haze, ray, t); }, stretch, 12, 1e-9);
    }
    return sum;
}

double airRadiance(const BeamModel& beam, const HazeModel& haze, const Ray& ray, std::span<const Stretch> lit,
                   const std::function<double(double)>& transmission) {
    double sum = 0.0;
    for (const Stretch& stretch : lit) {
        const auto f = [&](double t) { return integrand(beam, haze, ray, t) * transmission(t); };
        sum += integrate(f, stretch, 10, 1e-6);
    }
    return sum;
}

}  // namespace hazer::render::oracle
