#include "app/report/statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace hazer::app {
namespace {

constexpr double kLitShare = 1e-4;

double lengthOf(const float* rgb) {
    return std::hypot(rgb[0], rgb[1], rgb[2]);
}

double distanceBetween(const float* a, const float* b) {
    const double distance = std::hypot(static_cast<double>(a[0]) - b[0], static_cast<double>(a[1]) - b[1],
                                       static_cast<double>(a[2]) - b[2]);
    return std::isnan(distance) ? std::numeric_limits<double>::infinity() : distance;
}

double rootMeanSquare(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value * value;
    return std::sqrt(sum / static_cast<double>(values.size()));
}

/// The smallest value that 99 of 100 do not exceed.
double ninetyNinth(std::vector<double> values) {
    const auto rank = static_cast<std::size_t>(std::ceil(0.99 * static_cast<double>(values.size())));
    const auto nth = values.begin() + static_cast<std::ptrdiff_t>(rank - 1);
    std::nth_element(values.begin(), nth, values.end());
    return *nth;
}

}  // namespace

double median(std::vector<double> values) {
    assert(!values.empty());
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

std::vector<std::size_t> litPixels(const render::FloatImage& picture) {
    double brightest = 0.0;
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
        brightest = std::max(brightest, lengthOf(&picture.rgb[i]));
    }
    std::vector<std::size_t> lit;
    for (std::size_t i = 0; i < picture.rgb.size() / 3; ++i) {
        if (lengthOf(&picture.rgb[3 * i]) > kLitShare * brightest) lit.push_back(i);
    }
    return lit;
}

PictureError pictureError(const render::FloatImage& picture, const render::FloatImage& reference) {
    assert(picture.rgb.size() == reference.rgb.size());
    const std::vector<std::size_t> lit = litPixels(reference);
    if (lit.empty()) return {};
    std::vector<double> errors, light;
    double unlitError = 0.0;
    auto nextLit = lit.begin();
    for (std::size_t i = 0; i < reference.rgb.size() / 3; ++i) {
        const double error = distanceBetween(&picture.rgb[3 * i], &reference.rgb[3 * i]);
        if (nextLit != lit.end() && *nextLit == i) {
            errors.push_back(error);
            light.push_back(lengthOf(&reference.rgb[3 * i]));
            ++nextLit;
        } else {
            unlitError = std::max(unlitError, error);
        }
    }
    const double scale = rootMeanSquare(light);
    return {errors.size(), rootMeanSquare(errors) / scale, ninetyNinth(errors) / scale,
            *std::max_element(errors.begin(), errors.end()) / scale, unlitError / scale};
}

TimeAtError timeAtError(std::span<const TimedError> measured, double rmsRel) {
    assert(!measured.empty());
    const auto good = std::find_if(measured.begin(), measured.end(),
                                   [rmsRel](const TimedError& point) { return point.rmsRel <= rmsRel; });
    if (good == measured.end()) return {false, measured.back().ms, measured.back().rmsRel};
    if (good == measured.begin() || good->rmsRel <= 0.0) return {true, good->ms, rmsRel};
    const TimedError& before = *(good - 1);
    const double share = std::log(before.rmsRel / rmsRel) / std::log(before.rmsRel / good->rmsRel);
    return {true, before.ms * std::pow(good->ms / before.ms, share), rmsRel};
}

}  // namespace hazer::app
