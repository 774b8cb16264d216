// An independent statement of the single-scattering integral: plain geometry in double, adaptive quadrature
// along the ray. Shares no formula with the shaders.
#pragma once

#include <glm/glm.hpp>

namespace hazer::test {

/// A beam of 1 cd with the virtual apex at the origin, shining along -Z.
struct OracleBeam {
    double cutHalfAngleRad = 0.3;   ///< Nothing beyond; below 90 degrees.
    double beamHalfAngleRad = 0.2;  ///< 50 %.
    double exponent = 0.0;          ///< Of the super-Gaussian; 0: flat.
    double profileCut = 0.0;        ///< Share of the peak subtracted as a pedestal.
    double apexToLensM = 0.0;
};

struct OracleHaze {
    double extinctionPerM = 0.01;
    double scatteringPerM = 0.01;
    double forwardG = 0.78;
    double backwardG = -0.58;
    double forwardWeight = 0.97;
};

/// Radiance [cd/m^2] that reaches `eye` against `direction` (unit), from the haze up to `endM` metres away.
double oracleRadiance(const OracleBeam& beam, const OracleHaze& haze, const glm::dvec3& eye,
                      const glm::dvec3& direction, double endM);

}  // namespace hazer::test
