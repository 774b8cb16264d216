#include "render/aperture_plan.h"

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
