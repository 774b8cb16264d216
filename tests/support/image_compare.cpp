#include "tests/support/image_compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace hazer::test {
namespace {

/// How many thresholds one value is off.
double thresholdsOff(double actual, double expected, const Tolerance& tolerance) {
    if (!std::isfinite(actual)) return std::numeric_limits<double>::infinity();
    const double difference = std::abs(actual - expected);
    if (difference == 0.0) return 0.0;
    return difference / (tolerance.absolute + tolerance.relative * std::abs(expected));
}

}  // namespace

Comparison compareImages(const render::FloatImage& actual, const render::FloatImage& expected,
                         const Tolerance& tolerance) {
    assert(actual.width == expected.width && actual.height == expected.height);
    Comparison result;
    int beyond = 0;
    for (int y = 0; y < actual.height; ++y) {
        for (int x = 0; x < actual.width; ++x) {
            double off = 0.0;
            for (int channel = 0; channel < 3; ++channel) {
                off =
                    std::max(off, thresholdsOff(static_cast<double>(actual.at(x, y)[channel]),
                                                static_cast<double>(expected.at(x, y)[channel]), tolerance));
            }
            if (off > 1.0) ++beyond;
            if (off > result.worstThresholds) {
                result.worstThresholds = off;
                result.worstX = x;
                result.worstY = y;
            }
        }
    }
    result.shareBeyond = static_cast<double>(beyond) / (static_cast<double>(actual.width) * actual.height);
    return result;
}

render::FloatImage differenceImage(const render::FloatImage& actual, const render::FloatImage& expected,
                                   float gain) {
    assert(actual.rgb.size() == expected.rgb.size());
    render::FloatImage difference = actual;
    for (std::size_t i = 0; i < difference.rgb.size(); ++i) {
        difference.rgb[i] = gain * std::abs(actual.rgb[i] - expected.rgb[i]);
    }
    return difference;
}

std::string describe(const Comparison& comparison, const render::FloatImage& actual,
                     const render::FloatImage& expected) {
    const float* got = actual.at(comparison.worstX, comparison.worstY);
    const float* wanted = expected.at(comparison.worstX, comparison.worstY);
    return fmt::format(
        "{:.4f} % of the pixels beyond the threshold, worst {:.3g} thresholds off at ({}, {}): ({:.6g}, "
        "{:.6g}, {:.6g}) instead of "
        "({:.6g}, {:.6g}, {:.6g})",
        100.0 * comparison.shareBeyond, comparison.worstThresholds, comparison.worstX, comparison.worstY,
        got[0], got[1], got[2], wanted[0], wanted[1], wanted[2]);
}

render::FloatImage toFloat(const render::ByteImage& image) {
    render::FloatImage result{image.width, image.height, {}};
    result.rgb.reserve(image.rgb.size());
    for (const std::uint8_t value : image.rgb) result.rgb.push_back(static_cast<float>(value));
    return result;
}

}  // namespace hazer::test
