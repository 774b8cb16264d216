// What a lamp sees of a body: where on the tangent plane of its view, and from how near to how far. No GL.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "render/mesh.h"

namespace hazer::render {

/// A square pyramid from the apex of a lamp: apex at the origin, looking along -Z.
struct LampView {
    double halfTangent = 1.0;  ///< The view reaches to x, y = -+halfTangent * (-z).
    double nearestM = 0.01;    ///< Begins at this distance along the axis; above 0.
};

/// A rectangle of directions, as (x, y) / -z.
struct TangentRect {
    glm::dvec2 low{0.0};
    glm::dvec2 high{0.0};

    bool operator==(const TangentRect&) const = default;
};

/// Where in a view something is.
struct ViewedPart {
    TangentRect rect;
    double nearM = 0.0;  ///< Along the axis, from the apex.
    double farM = 0.0;
};

/// A box with edges in any direction, in a view's frame: its middle and half of its three edges. A flat one
/// is fine.
struct EdgedBox {
    glm::dvec3 middleM{0.0};
    glm::dmat3 halfEdgesM{1.0};  ///< Columns.
};

/// The bounding box of a mesh, brought into a view's frame by a transform.
EdgedBox edgedBox(const BoundingBox& box, const glm::dmat4& viewFromMesh);

/// The part of a box that stands in a view, exactly: what encloses the box cut by the pyramid. None where no
/// part does.
std::optional<ViewedPart> viewBox(const EdgedBox& box, const LampView& view);

/// What encloses a sphere in a view; none where the sphere is before it, behind it or beside it.
std::optional<ViewedPart> viewSphere(const glm::dvec3& middleM, double radiusM, const LampView& view);

/// What lies in both; none where nothing does.
std::optional<ViewedPart> commonPart(const ViewedPart& a, const ViewedPart& b);

/// What encloses both.
ViewedPart enclosingPart(const ViewedPart& a, const ViewedPart& b);

/// Cuts a rectangle to what encloses the part of it inside the circle of this radius about the axis; none
/// where they do not meet.
std::optional<TangentRect> cutToCircle(const TangentRect& rect, double radius);

}  // namespace hazer::render
