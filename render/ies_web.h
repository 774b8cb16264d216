// A lamp's measured intensity in every direction, as the renderer looks it up.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "render/ies_table.h"
#include "render/photometry.h"

namespace hazer::render {

/// The web's picture: shaders/include/web.glsl has the same numbers. Half a degree around the axis; along it
/// rows are 0.0007 degrees apart on the axis, 0.06 at 1.5, 0.35 at 45 and 0.7 on the way back, so that a beam
/// of 3 degrees is told to a thousandth on the axis and to 2 % at 30 degrees beside it.
inline constexpr int kWebAzimuths = 720;
inline constexpr int kWebThetas = 513;

/// A web on a fixed grid, bilinear between its points. In the lamp's frame theta is the angle from the axis
/// -Z, and the azimuth goes from +X towards +Y: counter-clockwise, looking along the beam.
struct IesWeb {
    /// Intensity over the peak, 0..1; kWebThetas rows from the axis on of kWebAzimuths each.
    std::vector<float> relative;
    double peakCd = 0.0;  ///< Largest intensity of the file.
    double fluxLm = 0.0;  ///< Integral over the sphere, of any file: lumens that a file claims are not used.
    /// Beyond it everything is below 0.001 % of the peak; up to pi.
    double cutHalfAngleRad = 0.0;
    /// Beyond them the mean around the axis is below 50 % and 10 % of its largest value.
    double beamHalfAngleRad = 0.0;
    double fieldHalfAngleRad = 0.0;
    std::string warning;  ///< See IesTable.

    /// Intensity over the peak towards a direction of the lamp's frame, by the shaders' own formula.
    double relativeAt(const glm::dvec3& direction) const;
};

/// Resamples a table and measures it.
IesWeb makeIesWeb(const IesTable& table);

/// parseIesTable and makeIesWeb. Throws RenderError as the former does, and for a web so small that the grid
/// misses it.
IesWeb parseIesWeb(std::string_view bytes, std::string_view name);

/// The shape of a beam that has this web instead of a profile. Its angles are the web's: `fieldAngleRad`,
/// `beamAngleRad` and `edge` of the beam have no say, and a gobo's edge and the virtual apex are at the web's
/// field angle. The peak is the beam's `intensityCd` if above 0, else what makes `fluxLm` if above 0, else
/// the web's own.
BeamShape webShape(const Beam& beam, const IesWeb& web);

}  // namespace hazer::render
