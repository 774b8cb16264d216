// Which pictures a frame has to compose of apertures. Pure: no OpenGL.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "render/aperture.h"
#include "render/scene.h"

namespace hazer::render {

/// Bounds the memory of composed pictures: 1.4 MB each.
inline constexpr int kMostComposedApertures = 64;

/// A picture to compose: all that stands in the way of a beam, its first gobo included.
struct ComposedAperture {
    GoboId gobo = -1;
    double rotationRad = 0.0;  ///< Of that gobo.
    Aperture aperture;

    bool operator==(const ComposedAperture&) const = default;
};

/// The pictures in it, the gobo first.
std::vector<ApertureImage> imagesOf(const ComposedAperture& aperture);

/// Features of shaders/aperture.frag for so many pictures, 0..5.
std::vector<std::string> apertureFeatures(std::size_t images);

struct AperturePlan {
    std::vector<ComposedAperture> composed;  ///< Each once; at most kMostComposedApertures.
    std::vector<int> ofBeam;   ///< One per beam of the scene: index into `composed`; -1: none is needed.
    std::vector<int> leftOut;  ///< Beams that shine without their aperture, for want of memory.
};

/// What the beams in `seen`, indices into Scene::beams, need. A beam with a gobo and nothing but an iris
/// turns its picture as it turns its gobo, so that none has to be composed anew.
AperturePlan planApertures(const Scene& scene, std::span<const int> seen, const Settings& settings);

/// By how much the picture that a beam looks at is turned.
double pictureRotationRad(const Beam& beam);

}  // namespace hazer::render
