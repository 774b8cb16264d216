// The teapot that Martin Newell modelled at the University of Utah in 1975 from bicubic Bezier patches, with
// the bottom that came later. The numbers are his control points; here they are written as what they are made
// of: a profile that is turned, and two tubes (handle and spout) whose cross-sections are two arcs each.
#include <algorithm>
#include <array>
#include <cstddef>

#include "render/mesh.h"
#include "render/mesh_builder.h"

namespace hazer::render {
namespace {

/// Height of the knob's top above the bottom in Newell's units.
constexpr float kHeight = 3.15f;
/// Newell's quarter circles: inner control points at this share of the radius (0.5523 would be nearest to a
/// circle).
constexpr float kQuarterArc = 0.56f;
constexpr int kSegmentsPerPatch = 10;

using CurvePoints = std::array<glm::vec3, 4>;
using PatchPoints = std::array<CurvePoints, 4>;  ///< [along v][along u]

/// Body from the inner edge of the rim over the rim, down and under; then lid from the knob down. Four to a
/// patch, the last of one is the first of the next.
constexpr ProfilePoint kBodyProfile[] = {
    {1.4f, 2.4f},   {1.3375f, 2.53125f}, {1.4375f, 2.53125f}, {1.5f, 2.4f},   {1.75f, 1.875f},
    {2.0f, 1.35f},  {2.0f, 0.9f},        {2.0f, 0.45f},       {1.5f, 0.225f}, {1.5f, 0.15f},
    {1.5f, 0.075f}, {1.425f, 0.0f},      {0.0f, 0.0f},
};
constexpr ProfilePoint kLidProfile[] = {
    {0.0f, 3.15f}, {0.8f, 3.15f}, {0.0f, 2.85f}, {0.2f, 2.7f}, {0.4f, 2.55f}, {1.3f, 2.55f}, {1.3f, 2.4f},
};

/// A cross-section of handle or spout: its two ends in the XZ plane (in such an order that a tube which runs
/// to +X has the lower one first), and how far its inner control points lie to the sides.
struct TubeSection {
    glm::vec2 firstXz;
    glm::vec2 secondXz;
    float sideways;
};
constexpr TubeSection kHandle[] = {
    {{-1.5f, 2.25f}, {-1.6f, 2.025f}, 0.3f}, {{-2.5f, 2.25f}, {-2.3f, 2.025f}, 0.3f},
    {{-3.0f, 2.25f}, {-2.7f, 2.025f}, 0.3f}, {{-3.0f, 1.8f}, {-2.7f, 1.8f}, 0.3f},
    {{-3.0f, 1.35f}, {-2.7f, 1.575f}, 0.3f}, {{-2.65f, 0.9375f}, {-2.5f, 1.125f}, 0.3f},
    {{-1.9f, 0.6f}, {-2.0f, 0.9f}, 0.3f},
};
constexpr TubeSection kSpout[] = {
    {{1.7f, 0.6f}, {1.7f, 1.425f}, 0.66f},       {{3.1f, 0.825f}, {2.6f, 1.425f}, 0.66f},
    {{2.4f, 2.025f}, {2.3f, 2.1f}, 0.25f},       {{3.3f, 2.4f}, {2.7f, 2.4f}, 0.25f},
    {{3.525f, 2.49375f}, {2.8f, 2.475f}, 0.25f}, {{3.45f, 2.5125f}, {2.9f, 2.475f}, 0.15f},
    {{3.2f, 2.4f}, {2.8f, 2.4f}, 0.15f},
};

glm::vec3 curvePoint(const CurvePoints& p, float t) {
    const float s = 1.0f - t;
    return s * s * s * p[0] + 3.0f * s * s * t * p[1] + 3.0f * s * t * t * p[2] + t * t * t * p[3];
}

glm::vec3 curveDerivative(const CurvePoints& p, float t) {
    const float s = 1.0f - t;
    return 3.0f * (s * s * (p[1] - p[0]) + 2.0f * s * t * (p[2] - p[1]) + t * t * (p[3] - p[2]));
}

glm::vec3 patchNormal(const PatchPoints& patch, float u, float v) {
    // At a pole all points along u fall together and dP/du vanishes; a hair beside it the cross product is
    // sound.
    constexpr float kBesidePole = 1e-3f;
    v = std::clamp(v, kBesidePole, 1.0f - kBesidePole);
    CurvePoints acrossV;
    CurvePoints alongV;
    for (std::size_t i = 0; i < 4; ++i) {
        acrossV[i] = curvePoint(patch[i], u);
        alongV[i] = curveDerivative(patch[i], u);
    }
    return glm::normalize(glm::cross(curvePoint(alongV, v), curveDerivative(acrossV, v)));
}

void appendPatch(Mesh& mesh, const PatchPoints& patch) {
    appendSurface(mesh, kSegmentsPerPatch, kSegmentsPerPatch, [&](float u, float v) {
        CurvePoints acrossV;
        for (std::size_t i = 0; i < 4; ++i) acrossV[i] = curvePoint(patch[i], u);
        return Vertex{curvePoint(acrossV, v) / kHeight, patchNormal(patch, u, v)};
    });
}

/// Control points of a quarter circle about the Z axis that starts in the direction `start` and turns
/// clockwise seen from above, so that with a profile running down the outside is outside.
CurvePoints quarterArc(ProfilePoint point, glm::vec2 start) {
    const glm::vec2 end(start.y, -start.x);
    const auto at = [&](glm::vec2 direction) { return glm::vec3(point.radiusM * direction, point.heightM); };
    return {at(start), at(start + kQuarterArc * end), at(kQuarterArc * start + end), at(end)};
}

template <std::size_t kPoints>
void appendTurned(Mesh& mesh, const ProfilePoint (&profile)[kPoints]) {
    for (const glm::vec2 start : {glm::vec2(1, 0), glm::vec2(0, -1), glm::vec2(-1, 0), glm::vec2(0, 1)}) {
        for (std::size_t first = 0; first + 3 < kPoints; first += 3) {
            PatchPoints patch;
            for (std::size_t i = 0; i < 4; ++i) patch[i] = quarterArc(profile[first + i], start);
            appendPatch(mesh, patch);
        }
    }
}

/// Half a cross-section on one side (+1 or -1 along Y), in the order that keeps the outside outside.
CurvePoints halfSection(const TubeSection& section, float side) {
    const auto at = [](glm::vec2 xz, float y) { return glm::vec3(xz.x, y, xz.y); };
    CurvePoints points{at(section.firstXz, 0.0f), at(section.firstXz, side * section.sideways),
                       at(section.secondXz, side * section.sideways), at(section.secondXz, 0.0f)};
    if (side < 0.0f) std::reverse(points.begin(), points.end());
    return points;
}

template <std::size_t kSections>
void appendTube(Mesh& mesh, const TubeSection (&sections)[kSections]) {
    for (const float side : {-1.0f, 1.0f}) {
        for (std::size_t first = 0; first + 3 < kSections; first += 3) {
            PatchPoints patch;
            for (std::size_t i = 0; i < 4; ++i) patch[i] = halfSection(sections[first + i], side);
            appendPatch(mesh, patch);
        }
    }
}

}  // namespace

Mesh makeTeapot() {
    Mesh mesh;
    appendTurned(mesh, kBodyProfile);
    appendTurned(mesh, kLidProfile);
    appendTube(mesh, kHandle);
    appendTube(mesh, kSpout);
    return mesh;
}

}  // namespace hazer::render
