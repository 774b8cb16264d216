// What a picture shows instead of light: how wrong each pixel is, or what it cost.
#pragma once

#include <string>

#include "render/image.h"

namespace hazer::app {

/// How far each pixel is from a converged picture of the same size, as a share of the light there (or of a
/// hundredth of the picture's root mean square, in what is darker than that). The same number in all three
/// channels.
render::FloatImage errorView(const render::FloatImage& picture, const render::FloatImage& converged);

/// Colours for the numbers of a view: dark blue at `from`, through green, to yellow at `to`, in equal steps
/// of the logarithm; black below `from`. 0 < from < to.
render::ByteImage falseColor(const render::FloatImage& view, double from, double to);

/// What a view says in one line: its mean, the value that 99 of 100 pixels above 0 keep to, and the largest.
std::string viewSummary(const render::FloatImage& view);

}  // namespace hazer::app
