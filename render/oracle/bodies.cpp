#include "render/oracle/bodies.h"

#include <embree3/rtcore.h>

#include <cmath>
#include <vector>

#include "render/error.h"

namespace hazer::render::oracle {
namespace {

/// A mesh instance in double, relative to the origin.
struct PlacedMesh {
    std::size_t instance = 0;
    std::vector<glm::dvec3> positionsM;
    std::vector<glm::dvec3> normals;
    std::vector<std::uint32_t> indices;
};

PlacedMesh place(const MeshInstance& instance, std::size_t index, const Mesh& mesh,
                 const glm::dvec3& originM) {
    PlacedMesh placed{index, {}, {}, mesh.indices};
    const glm::dmat3 normalMatrix = glm::transpose(glm::inverse(glm::dmat3(instance.worldFromMesh)));
    for (const Vertex& vertex : mesh.vertices) {
        const glm::dvec4 local(glm::dvec3(vertex.positionM), 1.0);
        placed.positionsM.push_back(glm::dvec3(instance.worldFromMesh * local) - originM);
        placed.normals.push_back(normalMatrix * glm::dvec3(vertex.normal));
    }
    return placed;
}

RTCRay makeRay(const glm::dvec3& from, const glm::dvec3& direction, double endM) {
    RTCRay ray{};
    const glm::vec3 origin(from), along(direction);
    ray.org_x = origin.x;
    ray.org_y = origin.y;
    ray.org_z = origin.z;
    ray.dir_x = along.x;
    ray.dir_y = along.y;
    ray.dir_z = along.z;
    ray.tfar = static_cast<float>(endM);
    ray.mask = 0xffffffffu;
    return ray;
}

/// Owns an Embree object.
template <typename Handle, void (*kRelease)(Handle)>
class Owned {
 public:
    explicit Owned(Handle handle) : handle_(handle) {}
    ~Owned() { kRelease(handle_); }
    Owned(const Owned&) = delete;
    Owned& operator=(const Owned&) = delete;
    Handle get() const { return handle_; }

 private:
    Handle handle_;
};
using Device = Owned<RTCDevice, rtcReleaseDevice>;
using SceneTree = Owned<RTCScene, rtcReleaseScene>;

RTCDevice newDevice() {
    RTCDevice device = rtcNewDevice(nullptr);
    if (device == nullptr) throw RenderError("Embree does not start; reinstall libembree3");
    return device;
}

void attach(RTCDevice device, RTCScene tree, const PlacedMesh& placed, unsigned id) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* positions = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), placed.positionsM.size()));
    for (std::size_t i = 0; i < placed.positionsM.size(); ++i) positions[i] = glm::vec3(placed.positionsM[i]);
    auto* indices = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), placed.indices.size() / 3));
    std::copy(placed.indices.begin(), placed.indices.end(), indices);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(tree, geometry, id);
    rtcReleaseGeometry(geometry);
}

RTCScene newTree(RTCDevice device) {
    RTCScene tree = rtcNewScene(device);
    rtcSetSceneFlags(tree, RTC_SCENE_FLAG_ROBUST);
    return tree;
}

}  // namespace

struct Bodies::Impl {
    explicit Impl(const glm::dvec3& origin) : originM(origin) {}

    glm::dvec3 originM;
    Device device{newDevice()};
    SceneTree all{newTree(device.get())};
    SceneTree casters{newTree(device.get())};
    std::vector<PlacedMesh> placed;
};

Bodies::Bodies(const Scene& scene, std::span<const Mesh> meshes, const glm::dvec3& originM)
    : impl_(std::make_unique<Impl>(originM)) {
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const MeshInstance& instance = scene.instances[i];
        const Mesh& mesh = meshes[static_cast<std::size_t>(instance.mesh)];
        if (mesh.indices.empty()) continue;
        const auto id = static_cast<unsigned>(impl_->placed.size());
        impl_->placed.push_back(place(instance, i, mesh, originM));
        attach(impl_->device.get(), impl_->all.get(), impl_->placed.back(), id);
        if (instance.castsShadow) {
            attach(impl_->device.get(), impl_->casters.get(), impl_->placed.back(), id);
        }
    }
    rtcCommitScene(impl_->all.get());
    rtcCommitScene(impl_->casters.get());
}

Bodies::~Bodies() = default;

std::optional<BodyPoint> Bodies::firstHit(const glm::dvec3& fromM, const glm::dvec3& direction) const {
    const glm::dvec3 from = fromM - impl_->originM;
    RTCRayHit query{};
    query.ray = makeRay(from, direction, INFINITY);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(impl_->all.get(), &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    const PlacedMesh& placed = impl_->placed[query.hit.geomID];
    const std::uint32_t* corner = placed.indices.data() + 3 * static_cast<std::size_t>(query.hit.primID);
    // The triangle is Embree's answer; where the ray meets its plane is worked out anew in double.
    const glm::dvec3 a = placed.positionsM[corner[0]];
    const glm::dvec3 ab = placed.positionsM[corner[1]] - a;
    const glm::dvec3 ac = placed.positionsM[corner[2]] - a;
    const glm::dvec3 plane = glm::cross(ab, ac);
    BodyPoint point;
    point.instance = placed.instance;
    point.distanceM = glm::dot(a - from, plane) / glm::dot(direction, plane);
    const glm::dvec3 inTriangle = from + point.distanceM * direction - a;
    const double area = glm::dot(plane, plane);
    const double shareB = glm::dot(glm::cross(inTriangle, ac), plane) / area;
    const double shareC = glm::dot(glm::cross(ab, inTriangle), plane) / area;
    point.normal = glm::normalize((1.0 - shareB - shareC) * placed.normals[corner[0]] +
                                  shareB * placed.normals[corner[1]] + shareC * placed.normals[corner[2]]);
    if (glm::dot(point.normal, direction) > 0.0) point.normal = -point.normal;
    return point;
}

bool Bodies::isBlocked(const glm::dvec3& fromM, const glm::dvec3& toM) const {
    const glm::dvec3 way = toM - fromM;
    const double length = glm::length(way);
    if (length <= 0.0) return false;
    RTCRay ray = makeRay(fromM - impl_->originM, way / length, length);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(impl_->casters.get(), &context, &ray);
    return ray.tfar < 0.0f;
}

}  // namespace hazer::render::oracle
