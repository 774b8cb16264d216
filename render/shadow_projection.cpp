#include "render/shadow_projection.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "render/gpu_beam.h"

namespace hazer::render {
namespace {

/// Texels between the window's edge and the planned rectangle: a filter at its edge finds what is beyond.
constexpr int kMarginTexels = 2;
/// What is seen edge-on has no extent, and still needs a map to be drawn into.
constexpr double kLeastExtent = 1e-6;

}  // namespace

ShadowProjection shadowProjection(const ShadowFacePlan& face) {
    const double texels = face.sizeTexels - 2 * (kShadowRimTexels + kMarginTexels);
    const glm::dvec2 extent = glm::max(face.rect.high - face.rect.low, kLeastExtent);
    const glm::dvec2 middle = 0.5 * (face.rect.low + face.rect.high);
    ShadowProjection projection;
    projection.texelsPerTangent = texels / extent;
    const glm::dvec2 half = 0.5 * extent + double{kMarginTexels} / projection.texelsPerTangent;
    projection.window = {middle - half, middle + half};
    projection.nearM = face.nearM;
    projection.sizeTexels = face.sizeTexels;
    return projection;
}

glm::dmat4 clipFromFace(const ShadowProjection& projection) {
    const glm::dvec2 extent = projection.window.high - projection.window.low;
    const glm::dvec2 sum = projection.window.high + projection.window.low;
    glm::dmat4 clip(0.0);
    clip[0][0] = 2.0 / extent.x;
    clip[1][1] = 2.0 / extent.y;
    // w is -z, and depth after the division 2 near / w - 1.
    clip[2] = {sum.x / extent.x, sum.y / extent.y, 1.0, -1.0};
    clip[3][2] = 2.0 * projection.nearM;
    return clip;
}

glm::dmat4 clipFromWorld(const Beam& beam, const BeamShape& shape, int face,
                         const ShadowProjection& projection) {
    const glm::dmat4 faceFromWorld(faceFromLamp(face) * glm::transpose(beam.worldFromBeam));
    return clipFromFace(projection) * glm::translate(faceFromWorld, -apexPosition(beam, shape));
}

ShadowFaceRecord faceRecord(const ShadowProjection& projection, const ShadowTile& tile) {
    const glm::dvec2 origin(tile.originPx);
    const glm::dvec2 offset =
        origin + double{kShadowRimTexels} - projection.window.low * projection.texelsPerTangent;
    return {glm::vec4(glm::dvec4(projection.texelsPerTangent, offset)),
            glm::vec4(glm::dvec4(origin, tile.sizeTexels - 1, projection.nearM)),
            glm::vec4(glm::dvec4(projection.window.low, projection.window.high))};
}

ShadowFaceRecord emptyFaceRecord() {
    // Farther than anything: every point lies before the first caster.
    constexpr float kNeverM = 1e30f;
    return {glm::vec4(0.0f), glm::vec4(0.0f, 0.0f, 0.0f, kNeverM), glm::vec4(0.0f)};
}

int faceRecordCount(const ShadowMapPlan& map) {
    return map.isWide ? kCubeFaces : 1;
}

}  // namespace hazer::render
