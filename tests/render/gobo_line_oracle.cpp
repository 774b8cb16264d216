#include "tests/render/gobo_line_oracle.h"

#include <algorithm>
#include <cmath>

namespace hazer::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Where a ray is within a cone around -Z: the textbook quadratic. False if nowhere in front of the eye, or
/// not on a bounded stretch.
bool crossesCone(double tangent, const glm::dvec3& eye, const glm::dvec3& direction, double& from,
                 double& to) {
    const double t2 = tangent * tangent;
    const double a = direction.x * direction.x + direction.y * direction.y - t2 * direction.z * direction.z;
    const double b = eye.x * direction.x + eye.y * direction.y - t2 * eye.z * direction.z;
    const double c = eye.x * eye.x + eye.y * eye.y - t2 * eye.z * eye.z;
    if (a <= 0.0 || b * b <= a * c) return false;
    const double root = std::sqrt(b * b - a * c);
    from = (-b - root) / a;
    to = (-b + root) / a;
    return from > 0.0 && eye.z + from * direction.z < 0.0 && eye.z + to * direction.z < 0.0;
}

double intensity(const GoboLamp& lamp, double psiRad) {
    if (lamp.exponent == 0.0) return psiRad < lamp.fieldHalfAngleRad ? 1.0 : 0.0;
    const double gauss = std::exp(-std::log(2.0) * std::pow(psiRad / lamp.beamHalfAngleRad, lamp.exponent));
    return std::max((gauss - 0.005) / 0.995, 0.0);
}

double henyeyGreenstein(double cosTheta, double g) {
    return (1.0 - g * g) / (4.0 * kPi * std::pow(1.0 + g * g - 2.0 * g * cosTheta, 1.5));
}

/// Between the centres of texels, dark beyond the picture; q in the unit disc, y upwards.
double bilinear(const std::vector<std::uint8_t>& rgba, int size, int channel, const glm::dvec2& q) {
    const double x = (0.5 + 0.5 * q.x) * size - 0.5;
    const double y = (0.5 - 0.5 * q.y) * size - 0.5;
    const int left = static_cast<int>(std::floor(x));
    const int top = static_cast<int>(std::floor(y));
    double sum = 0.0;
    for (int row = top; row <= top + 1; ++row) {
        for (int column = left; column <= left + 1; ++column) {
            const double weight = (1.0 - std::abs(x - column)) * (1.0 - std::abs(y - row));
            if (row < 0 || row >= size || column < 0 || column >= size) continue;
            const int texel = row * size + column;
            sum += weight * rgba[static_cast<std::size_t>(4 * texel + channel)];
        }
    }
    return sum / 255.0;
}

}  // namespace

GoboRay::GoboRay(const GoboLamp& lamp, const GoboHaze& haze, const glm::dvec3& eye,
                 const glm::dvec3& direction, int samples) {
    const double tangent = std::tan(lamp.fieldHalfAngleRad);
    if (!crossesCone(lamp.reach * tangent, eye, direction, fromM_, toM_)) return;
    // Even steps across the gobo: 1 / z runs evenly there (perspective).
    const double nearM = -(eye.z + fromM_ * direction.z);
    const double farM = -(eye.z + toM_ * direction.z);
    for (int i = 0; i < samples; ++i) {
        const double x = (i + 0.5) / samples;
        const double perM = (1.0 - x) / nearM + x / farM;
        const double t = fromM_ + (toM_ - fromM_) * (x / farM) / perM;
        const double dt = (toM_ - fromM_) / (nearM * farM * perM * perM) / samples;
        const glm::dvec3 point = eye + t * direction;
        const double r = glm::length(point);
        const double psi = std::atan2(std::hypot(point.x, point.y), -point.z);
        const glm::dvec2 place = glm::dvec2(point) / -point.z / tangent;
        Sample sample;
        sample.onGobo = {std::cos(lamp.turnRad) * place.x + std::sin(lamp.turnRad) * place.y,
                         -std::sin(lamp.turnRad) * place.x + std::cos(lamp.turnRad) * place.y};
        sample.light = dt * intensity(lamp, psi) / (r * r) * std::exp(-haze.extinctionPerM * (t + r)) *
                       henyeyGreenstein(glm::dot(point / r, -direction), haze.forwardG);
        samples_.push_back(sample);
    }
}

double GoboRay::withoutGobo() const {
    double sum = 0.0;
    for (const Sample& sample : samples_) sum += sample.light;
    return sum;
}

double GoboRay::through(const std::vector<std::uint8_t>& rgba, int channel) const {
    return through(rgba, channel, [](const glm::dvec2&) { return 1.0; });
}

double GoboRay::through(const std::vector<std::uint8_t>& rgba, int channel,
                        const std::function<double(const glm::dvec2&)>& weight) const {
    const int size = static_cast<int>(std::lround(std::sqrt(static_cast<double>(rgba.size()) / 4.0)));
    double sum = 0.0;
    for (const Sample& sample : samples_)
        sum += sample.light * bilinear(rgba, size, channel, sample.onGobo) * weight(sample.onGobo);
    return sum;
}

}  // namespace hazer::test
