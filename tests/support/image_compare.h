// How far two pictures are apart, in three numbers.
#pragma once

#include <string>

#include "render/image.h"

namespace hazer::test {

/// What two pictures of the same scene may differ by.
struct Tolerance {
    double absolute = 0.0;  ///< In the unit of the picture.
    double relative =
        0.0;               ///< Of the expected value; together: threshold = absolute + relative * |expected|.
    double share = 0.0;    ///< Of all pixels that may have a value beyond the threshold, 0..1.
    double ceiling = 1.0;  ///< No value may be further off than this many thresholds.
};

/// Outcome of a comparison.
struct Comparison {
    double shareBeyond = 0.0;  ///< Of pixels with a value beyond the threshold, or not finite.
    double worstThresholds =
        0.0;         ///< The largest difference, as a multiple of its threshold; infinite for NaN.
    int worstX = 0;  ///< Pixel of the largest difference, from the left,
    int worstY = 0;  ///< and from the top.

    bool within(const Tolerance& tolerance) const {
        return shareBeyond <= tolerance.share && worstThresholds <= tolerance.ceiling;
    }
};

/// Compares value by value. The pictures have the same size. A value that is not finite is infinitely far
/// off.
Comparison compareImages(const render::FloatImage& actual, const render::FloatImage& expected,
                         const Tolerance& tolerance);

/// `gain` times the absolute difference.
render::FloatImage differenceImage(const render::FloatImage& actual, const render::FloatImage& expected,
                                   float gain);

/// One sentence with the numbers of a comparison and the values at its worst pixel.
std::string describe(const Comparison& comparison, const render::FloatImage& actual,
                     const render::FloatImage& expected);

/// The display picture as numbers 0..255.
render::FloatImage toFloat(const render::ByteImage& image);

}  // namespace hazer::test
