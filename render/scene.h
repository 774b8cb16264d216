// What there is to draw: beams, bodies, haze, camera, exposure. Plain data, no GL, no DMX.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <vector>

#include "render/air_quality.h"
#include "render/aperture.h"

namespace hazer::render {

/// Colours in this module are linear light with Rec. 2020 primaries and D65 white.
using Color = glm::vec3;

/// Handles given out by Renderer; -1 is none.
using MeshId = int;
using GoboId = int;
using WebId = int;

enum class BeamEdge : std::uint8_t { kFlat, kSoft };

/// One beam of light. Everything is of this moment; motion and DMX are somebody else's business.
struct Beam {
    glm::dvec3 lensPositionM{0.0};  ///< Centre of the lens, world.
    glm::dmat3 worldFromBeam{
        1.0};  ///< Columns: image-right, image-up (+Y), and +Z; light goes along -Z. Orthonormal.
    double lensRadiusM = 0.05;   ///< 0: a point source.
    double beamAngleRad = 0.3;   ///< Full angle at 50 % of the peak; at most fieldAngleRad.
    double fieldAngleRad = 0.4;  ///< Full angle at 10 % of the peak, for kFlat of the cone; (0, 6.2].
    double fluxLm = 0.0;       ///< Luminous flux that leaves the lens without gobo, iris, blades and further
                               ///< pictures; luminance of `color` is 1.
    double intensityCd = 0.0;  ///< Peak as seen from the virtual apex; above 0 it stands in for fluxLm.
    Color color{1.0f};         ///< Luminance (0.2627 R + 0.6780 G + 0.0593 B) of 1 unless black.
    BeamEdge edge = BeamEdge::kSoft;
    GoboId gobo = -1;
    double goboRotationRad = 0.0;  ///< Counter-clockwise, looking along the beam from the lens.
    double focusDistanceM = 0.0;   ///< Distance from the lens where the gobo is sharp; 0: sharp everywhere.
    double frostRad = 0.0;  ///< Width at half the peak of the Gaussian that frost scatters light into, full
                            ///< angle, 0..1. The angles above are those without frost.
    Aperture aperture;      ///< What stands in the beam's way besides the gobo.
    WebId web = -1;         ///< Photometric web that replaces the edge's profile; -1: none.
    bool castsShadow = true;
    bool showsLens = true;                 ///< The lens itself is drawn.
    std::optional<glm::dvec3> lensNormal;  ///< Where the lens faces, world, length 1; else along the beam.

    bool operator==(const Beam&) const = default;
};

struct Material {
    Color albedo{0.5f};       ///< Diffuse reflectance 0..1.
    float specular = 0.04f;   ///< Specular reflectance 0..1.
    float shininess = 32.0f;  ///< Blinn-Phong exponent, 1..1000.

    bool operator==(const Material&) const = default;
};

struct MeshInstance {
    MeshId mesh = -1;
    glm::dmat4 worldFromMesh{1.0};
    Material material;
    bool castsShadow = true;

    bool operator==(const MeshInstance&) const = default;
};

/// Two-lobe Henyey-Greenstein: weight * HG(forwardG) + (1 - weight) * HG(backwardG). The default is glycol
/// haze with droplets of 0.8 um (Mie theory, see docs/rendering.md).
struct PhaseFunction {
    float forwardG = 0.78f;
    float backwardG = -0.58f;
    float forwardWeight = 0.97f;
};

struct HazeNoise {
    float amount = 0.0f;  ///< 0: even; 1: density between 0 and 2 of the mean.
    float scaleM = 2.5f;  ///< Size of the largest swirls.
    glm::vec3 windMps{0.25f, 0.1f, 0.05f};
    float turbulence = 1.0f;  ///< 0: the swirls only drift; 1: they roll at a natural speed.
    std::uint32_t seed = 1;   ///< Another seed, other swirls.
};

struct Haze {
    float extinctionPerM = 0.01f;
    float scatteringPerM = 0.01f;  ///< At most extinctionPerM in a physical haze.
    PhaseFunction phase;
    HazeNoise noise;
    /// Treats light scattered by less than the forward lobe's width as not scattered at all
    /// (delta-Eddington), which stands in for most of multiple scattering in thick haze. Off: exact single
    /// scattering.
    bool deltaEddington = false;
};

/// Even light from everywhere, on surfaces only.
struct Ambient {
    Color color{1.0f};
    float illuminanceLx = 0.0f;

    bool operator==(const Ambient&) const = default;
};

struct Scene {
    std::vector<MeshInstance> instances;
    std::vector<Beam> beams;
    Haze haze;
    Ambient ambient;
    Color backgroundCdPerM2{0.0f};
    double timeS = 0.0;  ///< Moves the noise.
};

struct Camera {
    glm::dvec3 positionM{0.0, -10.0, 1.7};
    glm::dvec3 targetM{0.0, 0.0, 1.7};
    glm::dvec3 up{0.0, 0.0, 1.0};
    double verticalFovRad = 0.8;

    bool operator==(const Camera&) const = default;
};

enum class Integrator : std::uint8_t {
    kAngle,    ///< Gauss-Legendre over the angle at the lamp.
    kUniform,  ///< The thesis' method: evenly spaced samples along the whole view ray.
};

struct Settings {
    int width = 1280;
    int height = 720;
    float exposureEv100 = 8.0f;
    Integrator integrator = Integrator::kAngle;
    /// Nodes over the lit stretch, in fours (kAngle), or samples along the ray (kUniform); 0: as many as the
    /// beam needs, or the thesis' 110.
    int samples = 0;
    /// Largest root mean square error of the light in the air, as a share of it, 0.0001..0.5; 0: a good one.
    double maxError = 0.0;
    std::optional<AirQuality> quality = {};  ///< Stands in for maxError where its laws are measured.
    /// Pixels between the nodes where light in the air is integrated first; in between it is interpolated
    /// where that is good enough. 1: every pixel is integrated. 0: as the quality asks.
    int airStep = 0;
    bool countsIntegrals = false;  ///< The radiance is the number of integrals that each pixel took instead.
    bool shadows = true;
    bool gobos = true;
    bool bloom = true;  ///< Display only; never in the radiance.
    /// A frame takes until the tables of its gobos are built. Off, for a window: until then its gobos are
    /// sampled point by point.
    bool waitForTables = true;
};

}  // namespace hazer::render
