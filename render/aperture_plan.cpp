#include "render/aperture_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace hazer::render {
namespace {

ComposedAperture pictureOf(const Beam& beam, const BeamShape& shape) {
    ComposedAperture picture;
    picture.gobo = beam.gobo;
    picture.rotationRad = beam.goboRotationRad - pictureRotationRad(beam);
    picture.aperture = beam.aperture;
    const bool hasProfile = hasProfileInPicture(beam);
    const BeamShape open = hasProfile ? openShape(beam) : shape;
    const double fieldTangent = std::tan(open.fieldHalfAngleRad);
    picture.fieldRadius = fieldTangent / std::tan(shape.pictureHalfAngleRad);
    if (hasProfile) picture.profile = {fieldTangent, open.beamHalfAngleRad, open.exponent};
    return picture;
}

}  // namespace

std::vector<ApertureImage> imagesOf(const ComposedAperture& aperture) {
    std::vector<ApertureImage> images{{aperture.gobo, aperture.rotationRad}};
    images.insert(images.end(), aperture.aperture.images.begin(), aperture.aperture.images.end());
    std::erase_if(images, [](const ApertureImage& image) { return image.gobo == -1; });
    return images;
}

std::vector<std::string> apertureFeatures(const ComposedAperture& aperture) {
    std::vector<std::string> features;
    for (std::size_t i = 0; i < imagesOf(aperture).size(); ++i)
        features.push_back(fmt::format("IMAGE_{}", i));
    if (aperture.profile && aperture.profile->exponent > 0.0) features.emplace_back("PROFILE");
    return features;
}

bool hasGate(const ComposedAperture& aperture) {
    const bool endsFlat = aperture.profile && aperture.profile->exponent == 0.0;
    return endsFlat || !imagesOf(aperture).empty();
}

double pictureRotationRad(const Beam& beam) {
    return isRound(beam.aperture) ? beam.goboRotationRad : 0.0;
}

AperturePlan planApertures(const Scene& scene, std::span<const int> seen, std::span<const BeamShape> shapes,
                           const Settings& settings) {
    AperturePlan plan;
    plan.ofBeam.assign(scene.beams.size(), -1);
    if (!settings.gobos) return plan;
    for (const int index : seen) {
        const Beam& beam = scene.beams[static_cast<std::size_t>(index)];
        if (!needsPicture(beam)) continue;
        const ComposedAperture picture = pictureOf(beam, shapes[static_cast<std::size_t>(index)]);
        const auto same = std::ranges::find(plan.composed, picture);
        const auto place = std::distance(plan.composed.begin(), same);
        if (place == kMostComposedApertures) {
            plan.leftOut.push_back(index);
            continue;
        }
        if (same == plan.composed.end()) plan.composed.push_back(picture);
        plan.ofBeam[static_cast<std::size_t>(index)] = static_cast<int>(place);
    }
    return plan;
}

}  // namespace hazer::render
