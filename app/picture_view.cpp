#include "app/picture_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

namespace hazer::app {
namespace {

glm::vec3 colorAt(const render::FloatImage& image, std::size_t pixel) {
    return {image.rgb[3 * pixel], image.rgb[3 * pixel + 1], image.rgb[3 * pixel + 2]};
}

std::size_t pixelCount(const render::FloatImage& image) {
    return image.rgb.size() / 3;
}

double rootMeanSquare(const render::FloatImage& image) {
    double sum = 0.0;
    for (const float value : image.rgb) sum += static_cast<double>(value) * value;
    return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(pixelCount(image), 1)));
}

/// Lightness grows all the way, so that the order is seen without colour too.
glm::dvec3 scaleColor(double share) {
    static constexpr std::array<glm::dvec3, 5> kStops{
        {{0.07, 0.05, 0.32}, {0.10, 0.33, 0.62}, {0.11, 0.60, 0.55}, {0.55, 0.80, 0.28}, {1.00, 0.95, 0.45}}};
    const double place = std::clamp(share, 0.0, 1.0) * (kStops.size() - 1);
    const auto stop = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
    return glm::mix(kStops[stop], kStops[stop + 1], place - static_cast<double>(stop));
}

}  // namespace

render::FloatImage errorView(const render::FloatImage& picture, const render::FloatImage& converged) {
    render::FloatImage view{picture.width, picture.height, {}};
    view.rgb.reserve(picture.rgb.size());
    const auto darkest = static_cast<float>(0.01 * rootMeanSquare(converged));
    for (std::size_t i = 0; i < pixelCount(picture); ++i) {
        const glm::vec3 want = colorAt(converged, i);
        const float scale = std::max(glm::length(want), darkest);
        const float error = scale > 0.0f ? glm::length(colorAt(picture, i) - want) / scale : 0.0f;
        view.rgb.insert(view.rgb.end(), 3, error);
    }
    return view;
}

render::ByteImage falseColor(const render::FloatImage& view, double from, double to) {
    render::ByteImage image{view.width, view.height, {}};
    image.rgb.reserve(view.rgb.size());
    for (std::size_t i = 0; i < pixelCount(view); ++i) {
        const double value = view.rgb[3 * i];
        const glm::dvec3 color =
            value < from ? glm::dvec3(0.0) : scaleColor(std::log(value / from) / std::log(to / from));
        for (int c = 0; c < 3; ++c)
            image.rgb.push_back(static_cast<std::uint8_t>(std::lround(255.0 * color[c])));
    }
    return image;
}

std::string viewSummary(const render::FloatImage& view) {
    std::vector<double> values;
    double sum = 0.0;
    for (std::size_t i = 0; i < pixelCount(view); ++i) {
        const double value = view.rgb[3 * i];
        sum += value;
        if (value > 0.0) values.push_back(value);
    }
    if (values.empty()) return "0 everywhere";
    std::sort(values.begin(), values.end());
    const std::size_t high = (values.size() - 1) * 99 / 100;
    return fmt::format("mean {:.2e}, 99 % within {:.2e}, largest {:.2e}",
                       sum / static_cast<double>(pixelCount(view)), values[high], values.back());
}

}  // namespace hazer::app
