// Figures of the reports, as pure functions of numbers and pictures.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "render/image.h"

namespace hazer::app {

/// The middle value; of an even number the higher of the two in the middle. `values` must not be empty.
double median(std::vector<double> values);

/// Which pixels of a picture, counted row by row, are lit: their light, as the length of RGB, is above 1e-4
/// of the brightest's.
std::vector<std::size_t> litPixels(const render::FloatImage& picture);

/// How far a picture is from a reference, over the reference's lit pixels. The error of a pixel is the length
/// of its difference in RGB. All are shares of the root mean square of the reference's light over the lit
/// pixels, so that they compare with each other and between scenes.
struct PictureError {
    std::size_t litPixels = 0;
    double rmsRel = 0.0;       ///< Root mean square of the errors.
    double p99Rel = 0.0;       ///< 99 of 100 lit pixels have no larger error.
    double maxRel = 0.0;       ///< The largest error.
    double unlitMaxRel = 0.0;  ///< The largest error of the other pixels.
};

/// Both pictures have the same size. Pixels that are no numbers count as an infinite error. All zeros if the
/// reference is dark.
PictureError pictureError(const render::FloatImage& picture, const render::FloatImage& reference);

/// One point of error against time.
struct TimedError {
    double ms = 0.0;
    double rmsRel = 0.0;
};

/// When a method with a growing number of samples reaches an error.
struct TimeAtError {
    bool isReached = false;
    double ms = 0.0;      ///< If reached; else the longest measured.
    double rmsRel = 0.0;  ///< The error asked for if reached; else that of the longest measured.
};

/// `measured` is sorted by samples and not empty. Between the first point that is good enough and the one
/// before it, both logarithms are taken as linear.
TimeAtError timeAtError(std::span<const TimedError> measured, double rmsRel);

}  // namespace hazer::app
