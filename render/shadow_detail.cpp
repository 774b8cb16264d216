#include "render/shadow_detail.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "render/gpu_beam.h"

namespace hazer::render {
namespace {

/// Texels to the pixel, where the map is seen from nearest.
constexpr double kTexelsPerPixel = 2.0;
/// The camera is taken to be no nearer than this to what it looks at [m].
constexpr double kNearestLookM = 1.0;

/// Texels a unit of tangent that make kTexelsPerPixel, from the first caster to the end of the lamp's reach.
double texelsPerTangent(const glm::dvec3& apexM, const glm::dvec3& alongM, double nearM, double farM,
                        const ShadowDetail& detail) {
    const double scale = glm::dot(alongM, alongM);
    const double closestM = std::clamp(glm::dot(detail.cameraM - apexM, alongM) / scale, nearM, farM);
    double most = 0.0;
    for (const double axialM : {nearM, closestM, farM}) {
        const double lookM = std::max(glm::distance(apexM + axialM * alongM, detail.cameraM), kNearestLookM);
        most = std::max(most, axialM / lookM);
    }
    return kTexelsPerPixel * most / detail.pixelRad;
}

/// A power of two between the smallest and the largest tile.
int tileOf(double texels) {
    const double bounded = std::clamp(texels, double{kSmallestShadowTile}, double{kLargestShadowTile});
    return static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::ceil(bounded))));
}

std::int64_t texelsOf(const ShadowMapPlan& map) {
    std::int64_t sum = 0;
    for (const ShadowFacePlan& face : map.faces) sum += std::int64_t{face.sizeTexels} * face.sizeTexels;
    return sum;
}

std::int64_t texelsOf(const std::vector<ShadowMapPlan>& maps) {
    std::int64_t sum = 0;
    for (const ShadowMapPlan& map : maps) sum += texelsOf(map);
    return sum;
}

double peakOf(const std::vector<BeamShape>& shapes, const ShadowMapPlan& map) {
    return shapes[static_cast<std::size_t>(map.beam)].peakCd;
}

void leaveOutTheDimmest(const std::vector<BeamShape>& shapes, ShadowPlan& plan) {
    std::stable_sort(plan.maps.begin(), plan.maps.end(), [&](const ShadowMapPlan& a, const ShadowMapPlan& b) {
        return peakOf(shapes, a) > peakOf(shapes, b);
    });
    std::int64_t texels = texelsOf(plan.maps);
    while (texels > kMostShadowTexels) {
        texels -= texelsOf(plan.maps.back());
        plan.leftOut.push_back(plan.maps.back().beam);
        plan.maps.pop_back();
    }
}

}  // namespace

void chooseTileSizes(const Scene& scene, const std::vector<BeamShape>& shapes, const ShadowDetail& detail,
                     ShadowPlan& plan) {
    double brightestCd = 0.0;
    for (const ShadowMapPlan& map : plan.maps) brightestCd = std::max(brightestCd, peakOf(shapes, map));
    for (ShadowMapPlan& map : plan.maps) {
        const auto index = static_cast<std::size_t>(map.beam);
        const Beam& beam = scene.beams[index];
        const glm::dvec3 apexM = apexPosition(beam, shapes[index]);
        // A lamp of a sixteenth of the brightest's intensity has texels twice as wide; never more than that.
        const double weight = std::max(std::pow(peakOf(shapes, map) / brightestCd, 0.25), 0.5);
        for (ShadowFacePlan& face : map.faces) {
            const glm::dvec2 middle = 0.5 * (face.rect.low + face.rect.high);
            const glm::dvec3 alongM =
                beam.worldFromBeam * (glm::transpose(faceFromLamp(face.face)) * glm::dvec3(middle, -1.0));
            const glm::dvec2 extent = face.rect.high - face.rect.low;
            const double farM = std::max(plan.reach[index]->farM, face.nearM);
            face.sizeTexels = tileOf(weight * std::max(extent.x, extent.y) *
                                     texelsPerTangent(apexM, alongM, face.nearM, farM, detail));
        }
    }
    int largest = kLargestShadowTile;
    while (texelsOf(plan.maps) > kMostShadowTexels && largest > kSmallestShadowTile) {
        largest /= 2;
        for (ShadowMapPlan& map : plan.maps) {
            for (ShadowFacePlan& face : map.faces)
                face.sizeTexels = std::max(face.sizeTexels / 2, kSmallestShadowTile);
        }
    }
    if (texelsOf(plan.maps) > kMostShadowTexels) leaveOutTheDimmest(shapes, plan);
}

}  // namespace hazer::render
