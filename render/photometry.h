// Lumens, candelas and the shape of a beam, on the CPU. Angles are half angles in radians unless they say
// otherwise.
#pragma once

#include "render/scene.h"

namespace hazer::render {

/// A beam's profile as the shaders take it. Angles are seen from the virtual apex.
struct BeamShape {
    double beamHalfAngleRad = 0.0;   ///< 50 % of the peak; equals cutHalfAngleRad where the profile is flat.
    double fieldHalfAngleRad = 0.0;  ///< 10 % of the peak.
    double pictureHalfAngleRad =
        0.0;  ///< The disc of the picture that the beam is looked at through, gobo or composed aperture.
    double cutHalfAngleRad = 0.0;  ///< Nothing beyond; up to 179 degrees.
    double exponent = 0.0;         ///< Of the super-Gaussian, 1..12; 0: flat.
    double apexToLensM =
        0.0;  ///< The virtual apex lies this far behind the lens: the cone is as wide as the lens there.
    double peakCd = 0.0;  ///< On the axis, as seen from the virtual apex.
};

/// Does what stands in a beam's way have to be composed to a picture (render/aperture_plan.h)?
bool needsPicture(const Beam& beam);

/// Is the beam's profile part of that picture? Then the beam itself is flat.
bool hasProfileInPicture(const Beam& beam);

/// Derives the shape from a beam's angles, lens and flux. The integral of intensity over the sphere is the
/// flux. Angles out of range are clamped: field angle to 0.01..358 degrees (178 with a gobo), beam angle to
/// at most the field angle. An iris alone makes the cut narrower, and takes no light from within. A lamp of a
/// field of 179 degrees or more has its apex in the lens. Frost widens the profile as Gaussians add.
/// `isComposed`: the beam shines through a composed picture, whose mean over the profile takes what stands in
/// the way.
BeamShape beamShape(const Beam& beam, bool isComposed);

/// The same of a beam that has the picture that it needs.
BeamShape beamShape(const Beam& beam);

/// The same with nothing in the way, and without frost.
BeamShape openShape(const Beam& beam);

/// Solid angle weighted by the profile [sr]: the flux is the peak times this.
double profileSolidAngle(const BeamShape& shape);

/// Intensity at `psiRad` from the axis relative to the peak, by the shaders' own formula.
double relativeIntensity(const BeamShape& shape, double psiRad);

}  // namespace hazer::render
