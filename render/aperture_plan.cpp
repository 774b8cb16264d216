#include "render/aperture_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace hazer::render {
namespace {

bool needsPicture(const Beam& beam) {
    return !isOpen(beam.aperture) && !(beam.gobo < 0 && isIrisOnly(beam.aperture));
}

ComposedAperture pictureOf(const Beam& beam) {
    return {beam.gobo, beam.goboRotationRad - pictureRotationRad(beam), beam.aperture};
}

}  // namespace

std::vector<ApertureImage> imagesOf(const ComposedAperture& aperture) {
    std::vector<ApertureImage> images{{aperture.gobo, aperture.rotationRad}};
    images.insert(images.end(), aperture.aperture.images.begin(), aperture.aperture.images.end());
    std::erase_if(images, [](const ApertureImage& image) { return image.gobo < 0; });
    return images;
}

std::vector<std::string> apertureFeatures(std::size_t images) {
    std::vector<std::string> features;
    for (std::size_t i = 0; i < images; ++i) features.push_back(fmt::format("IMAGE_{}", i));
    return features;
}

double pictureRotationRad(const Beam& beam) {
    return isRound(beam.aperture) ? beam.goboRotationRad : 0.0;
}

AperturePlan planApertures(const Scene& scene, std::span<const int> seen, const Settings& settings) {
    AperturePlan plan;
    plan.ofBeam.assign(scene.beams.size(), -1);
    if (!settings.gobos) return plan;
    for (const int index : seen) {
        const Beam& beam = scene.beams[static_cast<std::size_t>(index)];
        if (!needsPicture(beam)) continue;
        const ComposedAperture picture = pictureOf(beam);
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
