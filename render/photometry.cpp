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

BeamShape beamShape(const Beam& beam) {
    BeamShape shape;
    const bool hasPlane = beam.gobo >= 0 || !isOpen(beam.aperture);
    const double field =
        std::clamp(beam.fieldAngleRad, kNarrowestFieldRad, hasPlane ? kWidestGoboFieldRad : kWidestFieldRad);
    const double edge = std::clamp(beam.beamAngleRad, 0.02 * field, field);
    shape.fieldHalfAngleRad = 0.5 * field;
    shape.cutHalfAngleRad = shape.fieldHalfAngleRad;
    shape.beamHalfAngleRad = shape.fieldHalfAngleRad;
    if (beam.edge == BeamEdge::kSoft && edge < 0.999 * field) {
        const double exponent = std::log(std::log(10.0) / std::log(2.0)) / std::log(field / edge);
        shape.exponent = std::clamp(exponent, kMinExponent, kMaxExponent);
        shape.beamHalfAngleRad = 0.5 * edge;
        const double cut = std::pow(-std::log2(glsl::Formulas<double>().PROFILE_CUT), 1.0 / shape.exponent);
        shape.cutHalfAngleRad = std::min(shape.beamHalfAngleRad * cut, widestCut(shape.fieldHalfAngleRad));
    }
    shape.apexToLensM = std::max(beam.lensRadiusM, 0.0) * apexPerRadius(shape.fieldHalfAngleRad);
    shape.peakCd =
        beam.intensityCd > 0.0 ? beam.intensityCd : std::max(beam.fluxLm, 0.0) / profileSolidAngle(shape);
    if (beam.gobo < 0 && isIrisOnly(beam.aperture)) closeIris(beam.aperture.irisRadius, shape);
    return shape;
}

}  // namespace hazer::render
