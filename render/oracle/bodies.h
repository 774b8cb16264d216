// The meshes of a scene as Embree sees them: what a ray meets first, and what stands between two points.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>

#include "render/mesh.h"
#include "render/scene.h"

namespace hazer::render::oracle {

/// A point of a body.
struct BodyPoint {
    double distanceM = 0.0;
    glm::dvec3 normal{0.0};    ///< Unit, towards where the ray came from.
    std::size_t instance = 0;  ///< Index into Scene::instances.
};

class Bodies {
 public:
    /// `meshes` are indexed by MeshId. Coordinates are kept relative to `originM`, in double; Embree finds
    /// triangles in float. Throws RenderError if Embree does not start.
    Bodies(const Scene& scene, std::span<const Mesh> meshes, const glm::dvec3& originM);
    ~Bodies();
    Bodies(const Bodies&) = delete;
    Bodies& operator=(const Bodies&) = delete;

    /// What a ray from `fromM` (world) meets first; empty if nothing.
    std::optional<BodyPoint> firstHit(const glm::dvec3& fromM, const glm::dvec3& direction) const;

    /// Does a body that casts shadows stand on the way between two points of the world?
    bool isBlocked(const glm::dvec3& fromM, const glm::dvec3& toM) const;

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace hazer::render::oracle
