#include "render/photometry.h"

#include <algorithm>
#include <cmath>

#include "render/glsl_as_cpp.h"

namespace hazer::render {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadPerDeg = kPi / 180.0;
// Above this the super-Gaussian is a flat top with a steep edge for every purpose.
constexpr double kMaxExponent = 12.0;
constexpr double kMinExponent = 1.0;
constexpr double kNarrowestFieldRad = 0.01 * kRadPerDeg;
constexpr double kWidestFieldRad = 358.0 * kRadPerDeg;
// A gobo lies on a plane before the lamp, and so does an aperture.
constexpr double kWidestGoboFieldRad = 178.0 * kRadPerDeg;
// Half angle from which on a lamp has no lens plane: it shines to all sides, or backwards, too.
constexpr double kNoLensRad = 89.5 * kRadPerDeg;

/// How far behind the lens the apex lies, over the lens' radius. Over the last half degree before kNoLensRad
/// it moves into the lens, so that nothing jumps.
double apexPerRadius(double fieldHalfAngleRad) {
    constexpr double kLastDegreeRad = 89.0 * kRadPerDeg;
    const double cotangent = 1.0 / std::tan(fieldHalfAngleRad);
    if (fieldHalfAngleRad < kLastDegreeRad) return cotangent;
    return std::max(std::min(cotangent, 2.0 * (kNoLensRad - fieldHalfAngleRad)), 0.0);
}

/// How far a soft beam may reach: to the lens plane, and within another degree of field all the way round.
double widestCut(double fieldHalfAngleRad) {
    const double beyond = std::clamp((fieldHalfAngleRad - kNoLensRad) / kRadPerDeg, 0.0, 1.0);
    return std::lerp(kNoLensRad, 0.5 * kWidestFieldRad, beyond);
}

/// An iris cuts off what is outside of it, and leaves the rest as bright as it was.
void closeIris(double radius, BeamShape& shape) {
    if (radius <= 0.0) shape.peakCd = 0.0;
    const double edge = std::atan(std::max(radius, 1e-4) * std::tan(shape.fieldHalfAngleRad));
    shape.cutHalfAngleRad = std::min(shape.cutHalfAngleRad, edge);
    if (shape.exponent == 0.0) shape.beamHalfAngleRad = shape.cutHalfAngleRad;
}

/// All of the shape but its peak.
BeamShape profileShape(const Beam& beam, double beamAngleRad, double fieldAngleRad, BeamEdge kind) {
    BeamShape shape;
    const bool hasPlane = beam.gobo >= 0 || !isOpen(beam.aperture);
    const double field =
        std::clamp(fieldAngleRad, kNarrowestFieldRad, hasPlane ? kWidestGoboFieldRad : kWidestFieldRad);
    const double edge = std::clamp(beamAngleRad, 0.02 * field, field);
    shape.fieldHalfAngleRad = 0.5 * field;
    shape.pictureHalfAngleRad = shape.fieldHalfAngleRad;
    shape.cutHalfAngleRad = shape.fieldHalfAngleRad;
    shape.beamHalfAngleRad = shape.fieldHalfAngleRad;
    if (kind == BeamEdge::kSoft && edge < 0.999 * field) {
        const double exponent = std::log(std::log(10.0) / std::log(2.0)) / std::log(field / edge);
        shape.exponent = std::clamp(exponent, kMinExponent, kMaxExponent);
        shape.beamHalfAngleRad = 0.5 * edge;
        const double cut = std::pow(-std::log2(glsl::Formulas<double>().PROFILE_CUT), 1.0 / shape.exponent);
        shape.cutHalfAngleRad = std::min(shape.beamHalfAngleRad * cut, widestCut(shape.fieldHalfAngleRad));
    }
    shape.apexToLensM = std::max(beam.lensRadiusM, 0.0) * apexPerRadius(shape.fieldHalfAngleRad);
    return shape;
}

/// The solid angle weighted by the profile after a stretch, over that before it. On the plane before the lamp
/// the stretch takes its determinant; a solid angle there is cos^3 of an area.
double stretchedShare(const BeamShape& shape, const glm::dmat2& stretch) {
    if (stretch == glm::dmat2(1.0)) return 1.0;
    constexpr int kRings = 32;
    constexpr int kTurns = 16;
    const double area = std::max(std::abs(glm::determinant(stretch)), kNarrowestStretch);
    double before = 0.0;
    double after = 0.0;
    for (int ring = 0; ring < kRings; ++ring) {
        const double psi = shape.cutHalfAngleRad * (ring + 0.5) / kRings;
        const double light = relativeIntensity(shape, psi);
        const double tangent = std::tan(psi);
        before += kTurns * light * std::sin(psi);
        for (int turn = 0; turn < kTurns; ++turn) {
            const double phi = 2.0 * kPi * turn / kTurns;
            const glm::dvec2 place = tangent * (stretch * glm::dvec2(std::cos(phi), std::sin(phi)));
            after += light * area * tangent * (1.0 + tangent * tangent) /
                     std::pow(1.0 + glm::dot(place, place), 1.5);
        }
    }
    return after / before;
}

/// Widths at half and at a tenth of the peak grow as those of Gaussians that are convolved; the flux stays.
BeamShape frostedShape(const Beam& beam, const BeamShape& open) {
    constexpr double kTenthOverHalf = 1.8226;
    const double beamAngle = std::hypot(beam.beamAngleRad, beam.frostRad);
    const double fieldAngle =
        std::max(std::hypot(beam.fieldAngleRad, kTenthOverHalf * beam.frostRad), beamAngle);
    BeamShape shape = profileShape(beam, beamAngle, fieldAngle, BeamEdge::kSoft);
    shape.peakCd = open.peakCd * profileSolidAngle(open) / profileSolidAngle(shape);
    return shape;
}

}  // namespace

double relativeIntensity(const BeamShape& shape, double psiRad) {
    if (psiRad >= shape.cutHalfAngleRad) return 0.0;
    if (shape.exponent == 0.0) return 1.0;
    return glsl::Formulas<double>().softProfile(psiRad, shape.beamHalfAngleRad, shape.exponent);
}

// Runs for every beam and frame, hence Gauss-Legendre.
double profileSolidAngle(const BeamShape& shape) {
    if (shape.exponent == 0.0) {
        const double s = std::sin(0.5 * shape.cutHalfAngleRad);
        return 4.0 * kPi * s * s;
    }
    constexpr int kPieces = 32;
    glsl::Formulas<double> formulas;
    const double piece = shape.cutHalfAngleRad / kPieces;
    double sum = 0.0;
    for (int p = 0; p < kPieces; ++p) {
        for (int i = 0; i < 4; ++i) {
            const double psi = (p + formulas.gaussNode4(i)) * piece;
            sum += formulas.gaussWeight4(i) * relativeIntensity(shape, psi) * std::sin(psi);
        }
    }
    return 2.0 * kPi * sum * piece;
}

bool needsPicture(const Beam& beam) {
    if (isOpen(beam.aperture)) return beam.gobo >= 0 && beam.frostRad > 0.0;
    return beam.gobo >= 0 || beam.frostRad > 0.0 || !isIrisOnly(beam.aperture);
}

bool hasProfileInPicture(const Beam& beam) {
    constexpr double kTurnAlone = 0.999;
    return beam.frostRad > 0.0 || std::abs(glm::determinant(beam.aperture.stretch)) < kTurnAlone;
}

BeamShape openShape(const Beam& beam) {
    BeamShape shape = profileShape(beam, beam.beamAngleRad, beam.fieldAngleRad, beam.edge);
    shape.peakCd =
        beam.intensityCd > 0.0 ? beam.intensityCd : std::max(beam.fluxLm, 0.0) / profileSolidAngle(shape);
    return shape;
}

BeamShape beamShape(const Beam& beam, bool isComposed) {
    const BeamShape open = openShape(beam);
    BeamShape shape = beam.frostRad > 0.0 ? frostedShape(beam, open) : open;
    if (!isComposed) {
        if (beam.aperture.irisRadius < 1.0) closeIris(beam.aperture.irisRadius, shape);
        return shape;
    }
    shape.peakCd =
        open.peakCd / (stretchedShare(open, beam.aperture.stretch) * rectangleShare(beam.aperture));
    const bool hasGate = beam.gobo >= 0 || hasImages(beam.aperture);
    const bool isFlat = hasProfileInPicture(beam);
    if (isFlat || !hasGate)
        shape.pictureHalfAngleRad = std::min(shape.cutHalfAngleRad, 0.5 * kWidestGoboFieldRad);
    if (isFlat) {
        shape.exponent = 0.0;
        shape.cutHalfAngleRad = shape.beamHalfAngleRad = shape.pictureHalfAngleRad;
    }
    return shape;
}

BeamShape beamShape(const Beam& beam) {
    return beamShape(beam, needsPicture(beam));
}

}  // namespace hazer::render
