#include "render/lamp_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace hazer::render {
namespace {

/// Keeps dot(normal, p) >= atLeast.
struct Plane {
    glm::dvec3 normal;
    double atLeast = 0.0;
};

std::array<Plane, 5> planesOf(const LampView& view) {
    const double t = view.halfTangent;
    return {{{{0.0, 0.0, -1.0}, view.nearestM},
             {{1.0, 0.0, -t}, 0.0},
             {{-1.0, 0.0, -t}, 0.0},
             {{0.0, 1.0, -t}, 0.0},
             {{0.0, -1.0, -t}, 0.0}}};
}

double heightOver(const Plane& plane, const glm::dvec3& point) {
    return glm::dot(plane.normal, point) - plane.atLeast;
}

/// Corner i of a box: bit k of i says which end of edge k.
glm::dvec3 cornerOf(const EdgedBox& box, int i) {
    const auto sign = [i](int k) { return (i >> k & 1) != 0 ? 1.0 : -1.0; };
    return box.middleM + box.halfEdgesM * glm::dvec3(sign(0), sign(1), sign(2));
}

using Polygon = std::vector<glm::dvec3>;

/// Sutherland and Hodgman 1974: the part of a convex polygon on the kept side of a plane.
void clip(Polygon& polygon, const Plane& plane, Polygon& scratch) {
    scratch.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3& here = polygon[i];
        const glm::dvec3& next = polygon[(i + 1) % polygon.size()];
        const double hereOver = heightOver(plane, here);
        const double nextOver = heightOver(plane, next);
        if (hereOver >= 0.0) scratch.push_back(here);
        if ((hereOver >= 0.0) != (nextOver >= 0.0)) {
            scratch.push_back(here + (next - here) * (hereOver / (hereOver - nextOver)));
        }
    }
    std::swap(polygon, scratch);
}

/// Grows around the points it is given.
class Extent {
 public:
    explicit Extent(const LampView& view) : view_(view) {}

    void add(const glm::dvec3& point) {
        // A point cut out by the near plane may round to before it.
        const double axialM = std::max(-point.z, view_.nearestM);
        const glm::dvec2 tangent =
            glm::clamp(glm::dvec2(point) / axialM, -view_.halfTangent, view_.halfTangent);
        part_.rect = {glm::min(part_.rect.low, tangent), glm::max(part_.rect.high, tangent)};
        part_.nearM = std::min(part_.nearM, axialM);
        part_.farM = std::max(part_.farM, axialM);
    }

    std::optional<ViewedPart> part() const { return part_.farM > 0.0 ? std::optional(part_) : std::nullopt; }

 private:
    static constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const LampView& view_;
    ViewedPart part_{{glm::dvec2(kInfinity), glm::dvec2(-kInfinity)}, kInfinity, 0.0};
};

/// The faces of the box, cut by the view.
void addFaces(const EdgedBox& box, const std::array<Plane, 5>& planes, Extent& extent) {
    // Corners around each face, see cornerOf.
    constexpr std::array<std::array<int, 4>, 6> kFaces{
        {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}}};
    Polygon polygon, scratch;
    for (const std::array<int, 4>& face : kFaces) {
        polygon.clear();
        for (const int corner : face) polygon.push_back(cornerOf(box, corner));
        for (const Plane& plane : planes) clip(polygon, plane, scratch);
        for (const glm::dvec3& point : polygon) extent.add(point);
    }
}

/// The corners of the view's near end that are inside the box.
void addNearEnd(const EdgedBox& box, const LampView& view, Extent& extent) {
    const double volumeM3 = std::abs(glm::determinant(box.halfEdgesM));
    if (!(volumeM3 > 0.0)) return;
    const glm::dmat3 unitFromView = glm::inverse(box.halfEdgesM);
    for (int i = 0; i < 4; ++i) {
        const glm::dvec3 corner =
            view.nearestM * glm::dvec3((i & 1) != 0 ? view.halfTangent : -view.halfTangent,
                                       (i & 2) != 0 ? view.halfTangent : -view.halfTangent, -1.0);
        const glm::dvec3 inBox = glm::abs(unitFromView * (corner - box.middleM));
        if (std::max({inBox.x, inBox.y, inBox.z}) <= 1.0) extent.add(corner);
    }
}

/// Tangents between which a circle (distance `besideM` from the axis, `axialM` along it) is seen from the
/// origin; false if it is not ahead at all.
bool circleTangents(double besideM, double axialM, double radiusM, double& low, double& high) {
    constexpr double kQuarter = 1.57079632679489662;
    const double distanceM = std::hypot(besideM, axialM);
    low = -std::numeric_limits<double>::infinity();
    high = std::numeric_limits<double>::infinity();
    if (distanceM <= radiusM) return true;
    const double middle = std::atan2(besideM, axialM);
    const double half = std::asin(radiusM / distanceM);
    if (middle - half >= kQuarter || middle + half <= -kQuarter) return false;
    if (middle - half > -kQuarter) low = std::tan(middle - half);
    if (middle + half < kQuarter) high = std::tan(middle + half);
    return true;
}

}  // namespace

EdgedBox edgedBox(const BoundingBox& box, const glm::dmat4& viewFromMesh) {
    const glm::dvec3 low(box.lowM);
    const glm::dvec3 high(box.highM);
    const glm::dvec3 half = 0.5 * (high - low);
    EdgedBox edged;
    edged.middleM = glm::dvec3(viewFromMesh * glm::dvec4(0.5 * (low + high), 1.0));
    for (int k = 0; k < 3; ++k) edged.halfEdgesM[k] = glm::dvec3(viewFromMesh[k]) * half[k];
    return edged;
}

std::optional<ViewedPart> viewBox(const EdgedBox& box, const LampView& view) {
    const std::array<Plane, 5> planes = planesOf(view);
    bool isInside = true;
    for (const Plane& plane : planes) {
        int over = 0;
        for (int i = 0; i < 8; ++i) over += heightOver(plane, cornerOf(box, i)) >= 0.0 ? 1 : 0;
        if (over == 0) return std::nullopt;
        isInside = isInside && over == 8;
    }
    Extent extent(view);
    if (isInside) {
        for (int i = 0; i < 8; ++i) extent.add(cornerOf(box, i));
    } else {
        addFaces(box, planes, extent);
        addNearEnd(box, view, extent);
    }
    return extent.part();
}

std::optional<ViewedPart> viewSphere(const glm::dvec3& middleM, double radiusM, const LampView& view) {
    const double axialM = -middleM.z;
    if (axialM + radiusM < view.nearestM) return std::nullopt;
    ViewedPart part;
    part.nearM = std::max(axialM - radiusM, view.nearestM);
    part.farM = axialM + radiusM;
    for (int k = 0; k < 2; ++k) {
        if (!circleTangents(middleM[k], axialM, radiusM, part.rect.low[k], part.rect.high[k]))
            return std::nullopt;
        part.rect.low[k] = std::max(part.rect.low[k], -view.halfTangent);
        part.rect.high[k] = std::min(part.rect.high[k], view.halfTangent);
        if (part.rect.low[k] > part.rect.high[k]) return std::nullopt;
    }
    return part;
}

std::optional<ViewedPart> commonPart(const ViewedPart& a, const ViewedPart& b) {
    const ViewedPart part{{glm::max(a.rect.low, b.rect.low), glm::min(a.rect.high, b.rect.high)},
                          std::max(a.nearM, b.nearM),
                          std::min(a.farM, b.farM)};
    const bool isEmpty =
        part.rect.low.x > part.rect.high.x || part.rect.low.y > part.rect.high.y || part.nearM > part.farM;
    return isEmpty ? std::nullopt : std::optional(part);
}

ViewedPart enclosingPart(const ViewedPart& a, const ViewedPart& b) {
    return {{glm::min(a.rect.low, b.rect.low), glm::max(a.rect.high, b.rect.high)},
            std::min(a.nearM, b.nearM),
            std::max(a.farM, b.farM)};
}

std::optional<TangentRect> cutToCircle(const TangentRect& rect, double radius) {
    TangentRect cut = rect;
    // Each axis is cut to where the circle is at its widest within the other axis' range; once is enough,
    // since the second cut only removes what the first has left outside.
    for (int k = 0; k < 2; ++k) {
        const int other = 1 - k;
        const double nearestOther = std::max({cut.low[other], -cut.high[other], 0.0});
        if (nearestOther > radius) return std::nullopt;
        const double reach = std::sqrt(radius * radius - nearestOther * nearestOther);
        cut.low[k] = std::max(cut.low[k], -reach);
        cut.high[k] = std::min(cut.high[k], reach);
        if (cut.low[k] > cut.high[k]) return std::nullopt;
    }
    return cut;
}

}  // namespace hazer::render
