// The shared formulas of gobo_table.glsl, set up for a lamp and a ray.
#pragma once

#include <cmath>

#include "render/gobo_table_formulas.h"
#include "tests/render/gobo_line_oracle.h"

namespace hazer::test {

/// The profile that a lamp's table holds.
inline render::GoboProfile goboProfile(const GoboLamp& lamp) {
    return {lamp.beamHalfAngleRad / lamp.fieldHalfAngleRad, lamp.exponent};
}

/// Radiance by the table, as a shader goes about it.
template <typename Scalar>
class GoboTableView : public render::glsl::GoboTableFormulas<Scalar> {
    using Base = render::glsl::GoboTableFormulas<Scalar>;
    using Vector = typename Base::Real3;

 public:
    GoboTableView(const GoboLamp& lamp, const GoboHaze& haze, const glm::dvec3& eye,
                  const glm::dvec3& direction)
        : ray(this->lampRay(Vector(eye), glm::normalize(Vector(direction)), Vector(0, 0, -1))) {
        const double perTangent = 1.0 / std::tan(lamp.fieldHalfAngleRad);
        const auto exponent = static_cast<Scalar>(lamp.exponent);
        goboTurn = {static_cast<Scalar>(perTangent * std::cos(lamp.turnRad)),
                    static_cast<Scalar>(perTangent * std::sin(lamp.turnRad))};
        isCrossing = this->goboLine(ray, goboTurn, exponent, line);
        if (!isCrossing) return;
        typename Base::BeamOptics optics{};
        optics.beamHalfAngle = static_cast<Scalar>(lamp.beamHalfAngleRad);
        optics.exponent = exponent;
        spread = this->goboNodeSpread(exponent);
        for (int i = 0; i < 4; ++i) {
            Scalar jacobian;
            const auto here = this->goboLineSample(ray, line, this->goboNode(i, spread), Scalar(0), jacobian);
            values[i] = jacobian *
                        this->phaseHenyeyGreenstein(here.cosScatter, static_cast<Scalar>(haze.forwardG)) *
                        std::exp(-static_cast<Scalar>(haze.extinctionPerM) * here.pathM) *
                        this->goboProfileRatio(optics, here, goboTurn) / ray.h;
        }
    }

    /// Radiance for a scattering coefficient of 1 /m, in the table's channels; the gobo is blurred as mip
    /// level blurLevel + blurSlope xi of its picture.
    glm::dvec3 through(const render::GoboTable& from, double blurLevel, double blurSlope = 0.0) {
        if (!isCrossing) return glm::dvec3(0.0);
        this->table = &from;
        const typename Base::GoboBlur blur{static_cast<Scalar>(blurLevel), static_cast<Scalar>(blurSlope)};
        return glm::dvec3(this->throughGobo(values, spread, line, Scalar(0), from.layers == 3, blur));
    }

    typename Base::LampRay ray;
    typename Base::GoboLine line;
    typename Base::Real2 goboTurn;
    typename Base::Real4 values{};
    Scalar spread{};
    bool isCrossing = false;
};

}  // namespace hazer::test
