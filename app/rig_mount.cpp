#include "app/rig_mount.h"

#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "fixtures/text.h"

namespace hazer::app {
namespace {

/// Each is looked for in a whole tree.
constexpr int kMostMounted = 2000;

using Path = std::span<const std::string_view>;

/// Along the whole path, from this geometry on.
std::optional<glm::dmat4> poseAlong(const fixtures::Geometry& geometry, Path path) {
    if (!fixtures::equalsIgnoringCase(geometry.name, path.front())) return std::nullopt;
    if (path.size() == 1) return geometry.parentFromGeometry;
    for (const fixtures::Geometry& child : geometry.children) {
        if (const auto below = poseAlong(child, path.subspan(1))) return geometry.parentFromGeometry * *below;
    }
    return std::nullopt;
}

std::optional<glm::dmat4> poseBelow(const fixtures::Geometry& geometry, Path path) {
    if (const auto here = poseAlong(geometry, path)) return here;
    for (const fixtures::Geometry& child : geometry.children) {
        if (const auto below = poseBelow(child, path)) return geometry.parentFromGeometry * *below;
    }
    return std::nullopt;
}

}  // namespace

std::optional<glm::dmat4> restPose(const fixtures::Geometry& root, std::string_view path) {
    const std::vector<std::string_view> names = fixtures::split(path, '.');
    return poseBelow(root, names);
}

glm::dmat4 RigMounts::worldFromScene(const fixtures::MvrScene& scene, int object, bool& isFound) {
    const fixtures::MvrObject& child = scene.objects[static_cast<std::size_t>(object)];
    const auto movedParent = moved_.find(child.parent);
    glm::dmat4 world = movedParent == moved_.end() ? glm::dmat4(1.0) : movedParent->second;
    isFound = true;
    if (child.device && !child.device->childPosition.empty()) {
        const auto mode = modes_.find(child.parent);
        const auto pose = mode == modes_.end() || ++mounted_ > kMostMounted
                              ? std::nullopt
                              : restPose(mode->second->geometry, child.device->childPosition);
        isFound = pose.has_value();
        if (isFound) {
            const glm::dmat4& parent = scene.objects[static_cast<std::size_t>(child.parent)].worldFromObject;
            // What is flat has no inside to hang something in.
            if (std::abs(glm::determinant(parent)) > 1e-12)
                world = world * parent * *pose * glm::inverse(parent);
        }
    }
    if (world != glm::dmat4(1.0)) moved_.emplace(object, world);
    return world;
}

}  // namespace hazer::app
