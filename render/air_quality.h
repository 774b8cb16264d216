// How finely light in the air is integrated, for an error that is asked for.
#pragma once

namespace hazer::render {

struct Settings;

struct AirQuality {
    int gridStep = 1;  ///< Pixels between the nodes that are integrated first; 1: every pixel.
    double gridTolerance =
        0.0;                   ///< Estimated error that a pixel between nodes may have, a share of the light.
    int shadowIntervals = 16;  ///< Of the part of a ray that may be shaded; 4..232.
    int shadowBisections = 5;  ///< Of an interval at an edge of a shadow; at least 1.
    int profilePairs = 4;  ///< Pairs of nodes on either side of a soft beam's axis, where a ray is cut; 2..4.
    int goboTaps = 32;     ///< Along the line on a gobo, where its table does not serve.
    double goboTolerance =
        0.02;  ///< How far what is smooth along a gobo's line may be from a cubic, a share.
    double goboLevelsApart =
        0.3;             ///< How far its blur may differ along a line that its table serves, in mip levels.
    int noiseNodes = 8;  ///< Looks at uneven haze along the lit part of a ray.
};

/// The error that is kept to when none is asked for.
inline constexpr double kDefaultMaxError = 0.025;

/// The cheapest quality whose root mean square error, as a share of that of the light in the air, stays below
/// `maxError` (0.0001..0.5), by the error laws in docs/rendering.md.
AirQuality airQualityFor(double maxError);

/// The quality that the settings ask for, with their own grid step if they name one. Where no error is
/// allowed for, with given samples, and by the thesis' integrator every pixel is integrated.
AirQuality airQuality(const Settings& settings);

}  // namespace hazer::render
