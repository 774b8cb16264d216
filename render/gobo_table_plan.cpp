#include "render/gobo_table_plan.h"

#include <cmath>

namespace hazer::render {
namespace {

/// The tables' cubic does not follow what a wider beam's light does along a ray.
constexpr double kWidestHalfAngleRad = 0.61;
/// Steps of a rounded profile: the intensity is less than 0.3 % of the peak off, at the steepest edge.
constexpr double kBeamOverFieldSteps = 1024.0;
constexpr double kExponentSteps = 128.0;

double rounded(double value, double steps) {
    return std::round(value * steps) / steps;
}

}  // namespace

GoboTableKey goboTableKey(const Beam& beam, const BeamShape& shape) {
    if (beam.gobo < 0 || shape.fieldHalfAngleRad > kWidestHalfAngleRad) return {};
    if (shape.exponent == 0.0) return {beam.gobo, {}};
    const double beamOverField = shape.beamHalfAngleRad / shape.fieldHalfAngleRad;
    return {beam.gobo,
            {rounded(beamOverField, kBeamOverFieldSteps), rounded(shape.exponent, kExponentSteps)}};
}

std::vector<GoboTableKey> goboTableKeys(const Scene& scene, const Settings& settings, const ScenePlan& plan) {
    std::vector<GoboTableKey> keys(scene.beams.size());
    if (settings.samples > 0) return keys;
    for (const BeamGroup& group : plan.airGroups) {
        if ((group.features & kFeatureGobo) == 0 || (group.features & kFeatureUniform) != 0) continue;
        for (const int index : group.beams) {
            const auto beam = static_cast<std::size_t>(index);
            if (plan.apertures.ofBeam[beam] >= 0) continue;
            keys[beam] = goboTableKey(scene.beams[beam], plan.shapes[beam]);
        }
    }
    return keys;
}

}  // namespace hazer::render
