// What stands in a beam's way inside the fixture besides its first gobo: iris, blades, further wheels, a
// mask, two colours at once. Plain data.
//
// Places are those of the beam's cross-section: the field of the beam is the unit disc, +X is image-right and
// +Y image-up, seen from the fixture along the beam.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace hazer::render {

/// A picture that was added as a gobo, wherever it lies: what is outside its disc is dark.
struct ApertureImage {
    int gobo = -1;             ///< GoboId; -1: nothing is there.
    double rotationRad = 0.0;  ///< Counter-clockwise.
    glm::dvec2 center{0.0};    ///< Of its disc.
    double radius = 1.0;       ///< Of its disc, above 0.

    bool operator==(const ApertureImage&) const = default;
};

/// A straight edge: light passes where dot(normal, place) is below `distance`.
struct ApertureEdge {
    glm::dvec2 normal{1.0, 0.0};  ///< Of length 1; points at the blade.
    double distance = 2.0;        ///< From the middle of the beam; from 1 on the edge is out of the field.

    bool operator==(const ApertureEdge&) const = default;
};

inline constexpr double kNarrowestStretch = 0.02;

enum class ApertureShape : std::uint8_t { kRound, kRectangle, kOval };

struct Aperture {
    std::array<ApertureImage, 4> images;
    double irisRadius = 1.0;  ///< 1: out of the field; 0: shut.
    std::array<ApertureEdge, 4> blades;
    ApertureShape shape = ApertureShape::kRound;
    glm::dvec2 halfSize{
        1.0};  ///< Of a rectangle or an oval; reaches the field's edge where its corner has length 1.
    double shapeTurnRad = 0.0;  ///< Of the rectangle or oval, counter-clockwise.
    double softness = 0.0;      ///< Width over which the edges above go from dark to open.
    /// Beyond this edge the light has `beyondColor`, and `color` on the side of the middle. Transmission,
    /// 0..1.
    ApertureEdge split;
    glm::vec3 color{1.0f};
    glm::vec3 beyondColor{1.0f};
    /// Of all this and of the beam's gobo, as through a cylindrical lens: a place p comes to stretch * p. Its
    /// longest axis has length 1, its shortest at least kNarrowestStretch.
    glm::dmat2 stretch{1.0};

    bool operator==(const Aperture&) const = default;
};

/// Nothing of it is in the beam's way.
bool isOpen(const Aperture& aperture);

/// Nothing but an iris is in the beam's way: a narrower beam, without any picture.
bool isIrisOnly(const Aperture& aperture);

/// Does it look the same however it is turned?
bool isRound(const Aperture& aperture);

}  // namespace hazer::render
