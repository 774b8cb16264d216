// What stands in a beam's way inside the fixture besides its first gobo: iris, blades, further wheels, a
// mask, two colours at once. Plain data.
//
// Places are those of the beam's cross-section: the field of the beam is the unit disc, +X is image-right and
// +Y image-up, seen from the fixture along the beam.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

namespace hazer::render {

/// What stands for an open place of a wheel where a GoboId may be.
inline constexpr int kOpenSlot = -2;

/// A picture that was added as a gobo, wherever it lies: what is outside its disc is dark.
struct ApertureImage {
    int gobo = -1;               ///< GoboId or kOpenSlot; -1: nothing is there.
    double rotationRad = 0.0;    ///< Counter-clockwise; also of the neighbour's picture.
    glm::dvec2 center{0.0};      ///< Of its disc.
    double radius = 1.0;         ///< Of its disc, above 0.
    int neighbor = -1;           ///< The next place of the wheel, as `gobo`; its disc is as large.
    glm::dvec2 toNeighbor{0.0};  ///< From middle to middle, at least the discs' diameter.

    bool operator==(const ApertureImage&) const = default;
};

/// A straight edge: light passes where dot(normal, place) is below `distance`.
struct ApertureEdge {
    glm::dvec2 normal{1.0, 0.0};  ///< Of length 1; points at the blade.
    double distance = 2.0;        ///< From the middle of the beam; from 1 on the edge is out of the field.

    bool operator==(const ApertureEdge&) const = default;
};

inline constexpr double kNarrowestStretch = 0.02;

/// The shape of a beam whose lamp is a rectangle: full light within, none from `halfSize` on.
struct RectangleEdge {
    glm::dvec2 halfSize{0.7071, 0.7071};  ///< Reaches the field's edge where its corner has length 1.
    double softness = 0.0;                ///< Width of the ramp within, 0..2 times the smaller half size.

    bool operator==(const RectangleEdge&) const = default;
};

struct Aperture {
    std::array<ApertureImage, 4> images;
    double irisRadius = 1.0;  ///< 1: out of the field; 0: shut.
    std::array<ApertureEdge, 4> blades;
    double softness = 0.0;  ///< Width over which iris and blades go from dark to open.
    std::optional<RectangleEdge> rectangle;
    /// Beyond this edge the light has `beyondColor`, and `color` on the side of the middle. Transmission,
    /// 0..1.
    ApertureEdge split;
    glm::vec3 color{1.0f};
    glm::vec3 beyondColor{1.0f};
    /// Of all this, of the beam's gobo and its profile, as through a cylindrical lens: a place p comes to
    /// stretch * p. Its longest axis has length 1, its shortest at least kNarrowestStretch. It takes no
    /// light.
    glm::dmat2 stretch{1.0};

    bool operator==(const Aperture&) const = default;
};

/// Nothing of it is in the beam's way.
bool isOpen(const Aperture& aperture);

/// Nothing but an iris is in the beam's way: a narrower beam, without any picture.
bool isIrisOnly(const Aperture& aperture);

/// Does it look the same however it is turned?
bool isRound(const Aperture& aperture);

/// Is there a picture in it?
bool hasImages(const Aperture& aperture);

/// The rectangle's share of the field, (0, 1]: light is as much denser.
double rectangleShare(const Aperture& aperture);

}  // namespace hazer::render
