// One beam in even haze by plain geometry: the single-scattering integral along a ray, in double, by adaptive
// Gauss-Kronrod quadrature. Shares no formula with the shaders: it is what they are held against.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace hazer::render::oracle {

/// A beam of 1 cd with its virtual apex at the origin, shining along -Z.
struct BeamModel {
    double cutHalfAngleRad = 0.3;   ///< Nothing beyond; (0, pi).
    double beamHalfAngleRad = 0.2;  ///< 50 % of the peak.
    double exponent = 0.0;          ///< Of the super-Gaussian; 0: flat.
    double profileCut = 0.0;        ///< Share of the peak subtracted as a pedestal.
    double apexToLensM = 0.0;       ///< Light starts at this plane; 0: at the apex.
    /// Intensity over the peak towards a direction (unit), instead of the profile; empty: none.
    std::function<double(const glm::dvec3&)> web = {};
};

/// Two lobes of Henyey and Greenstein.
struct HazeModel {
    double extinctionPerM = 0.01;
    double scatteringPerM = 0.01;
    double forwardG = 0.78;
    double backwardG = -0.58;
    double forwardWeight = 0.97;
};

struct Ray {
    glm::dvec3 originM{0.0};
    glm::dvec3 direction{0.0, 0.0, -1.0};  ///< Unit length.
    double endM = 1e5;                     ///< Where it meets something.
};

/// Part of a ray, in metres from its origin.
struct Stretch {
    double fromM = 0.0;
    double toM = 0.0;
};

/// Phase function [1/sr]; cosTheta is between the way of the light and the way it is scattered to.
double phase(const HazeModel& haze, double cosTheta);

/// Intensity [cd] towards a point; 0 outside the beam and behind the lens.
double intensityTowards(const BeamModel& beam, const glm::dvec3& pointM);

/// Length [m] of the light's way from the lens to a point of the beam.
double wayFromLensM(const BeamModel& beam, const glm::dvec3& pointM);

/// The parts of a ray inside the beam, cut where the integrand is not smooth or steepest: cone, lens plane,
/// and around the point closest to the apex.
std::vector<Stretch> smoothStretches(const BeamModel& beam, const Ray& ray);

/// `count` parts of a stretch that are seen from the apex under even angles.
std::vector<Stretch> splitByAngle(const Ray& ray, const Stretch& stretch, int count);

/// Radiance [cd/m^2] that reaches the ray's origin against its direction.
double airRadiance(const BeamModel& beam, const HazeModel& haze, const Ray& ray);

/// The same over `lit` stretches alone, each smooth but for `transmission(t)`, which multiplies the light t
/// metres from the origin and may have kinks: to 1e-6 of a stretch's own light, as far as 10 halvings go.
double airRadiance(const BeamModel& beam, const HazeModel& haze, const Ray& ray, std::span<const Stretch> lit,
                   const std::function<double(double)>& transmission);

}  // namespace hazer::render::oracle
