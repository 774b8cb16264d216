// Which pictures a frame has to compose of apertures. Pure: no OpenGL.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/aperture.h"
#include "render/photometry.h"
#include "render/scene.h"

namespace hazer::render {

/// Bounds the memory of composed pictures: 1.4 MB each.
inline constexpr int kMostComposedApertures = 64;

/// A beam's profile where it is part of the picture.
struct PictureProfile {
    double fieldTangent = 0.0;      ///< Of half the field angle.
    double beamHalfAngleRad = 0.0;  ///< Where it is 50 %.
    double exponent = 0.0;          ///< Of the super-Gaussian; 0: flat, up to the field.

    bool operator==(const PictureProfile&) const = default;
};

/// A picture to compose: all that stands in the way of a beam, its first gobo included.
struct ComposedAperture {
    GoboId gobo = -1;
    double rotationRad = 0.0;  ///< Of that gobo.
    Aperture aperture;
    double fieldRadius = 1.0;  ///< Of the beam's field on the picture, whose disc has radius 1.
    std::optional<PictureProfile> profile;

    bool operator==(const ComposedAperture&) const = default;
};

/// The pictures in it, the gobo first.
std::vector<ApertureImage> imagesOf(const ComposedAperture& aperture);

/// Features of shaders/aperture.frag that it takes.
std::vector<std::string> apertureFeatures(const ComposedAperture& aperture);

/// Is light cut off at the field's edge? Where there are pictures, there is a gate that holds them.
bool hasGate(const ComposedAperture& aperture);

struct AperturePlan {
    std::vector<ComposedAperture> composed;  ///< Each once; at most kMostComposedApertures.
    std::vector<int> ofBeam;   ///< One per beam of the scene: index into `composed`; -1: none is needed.
    std::vector<int> leftOut;  ///< Beams that shine without their aperture, for want of memory.
};

/// What the beams in `seen`, indices into Scene::beams, need; `shapes` has one per beam of the scene. A beam
/// with a gobo and nothing but an iris turns its picture as it turns its gobo, so that none has to be
/// composed anew.
AperturePlan planApertures(const Scene& scene, std::span<const int> seen, std::span<const BeamShape> shapes,
                           const Settings& settings);

/// By how much the picture that a beam looks at is turned.
double pictureRotationRad(const Beam& beam);

}  // namespace hazer::render
