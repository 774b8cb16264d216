#include "render/mesh_surface.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <tuple>

namespace hazer::render {
namespace {

/// cos 50 degrees.
constexpr double kSmoothestEdge = 0.6428;
/// More corners than this in one place are the tip of a fan, or an attack: these stay flat.
constexpr std::size_t kMostCornersOfPlace = 64;

bool isFinite(glm::vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Products of floats, which neither vanish nor overflow in double.
glm::dvec3 areaNormal(const MeshSurface& surface, const std::array<std::uint32_t, 3>& triangle) {
    const glm::dvec3 a(surface.positionsM[triangle[0]]);
    return glm::cross(glm::dvec3(surface.positionsM[triangle[1]]) - a,
                      glm::dvec3(surface.positionsM[triangle[2]]) - a);
}

bool isDirection(const glm::dvec3& normal) {
    const double length = glm::length(normal);
    return length > 0.0 && std::isfinite(length);
}

/// Triangles whose corners are where the others' are share places, also where a file repeats its vertices.
std::vector<std::uint32_t> placesOf(const std::vector<glm::vec3>& positionsM, std::size_t& count) {
    std::vector<std::uint32_t> order(positionsM.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t i) {
        return std::tuple(positionsM[i].x, positionsM[i].y, positionsM[i].z);
    };
    std::ranges::sort(order, {}, key);
    std::vector<std::uint32_t> places(positionsM.size());
    count = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i == 0 || key(order[i]) != key(order[i - 1])) ++count;
        places[order[i]] = static_cast<std::uint32_t>(count - 1);
    }
    return places;
}

/// Makes the normals of a surface that has none.
class Smoother {
 public:
    Smoother(const MeshSurface& surface, Mesh& mesh)
        : surface_(surface), mesh_(mesh), places_(placesOf(surface.positionsM, placeCount_)) {
        for (const auto& triangle : surface.triangles) areaNormals_.push_back(areaNormal(surface, triangle));
        groupCorners();
    }

    void append() {
        mesh_.indices.reserve(mesh_.indices.size() + 3 * surface_.triangles.size());
        emitted_.resize(corners_.size(), kNone);
        for (std::size_t i = 0; i < surface_.triangles.size(); ++i) {
            if (!isDirection(areaNormals_[i])) continue;
            for (const std::uint32_t corner : surface_.triangles[i]) {
                mesh_.indices.push_back(vertexOf(corner, static_cast<std::uint32_t>(i)));
            }
        }
    }

 private:
    static constexpr std::uint32_t kNone = 0xFFFFFFFF;

    // corners_[starts_[place]..starts_[place + 1]] are the triangles that have a corner there.
    void groupCorners() {
        starts_.assign(placeCount_ + 1, 0);
        for (const auto& triangle : surface_.triangles)
            for (const std::uint32_t corner : triangle) ++starts_[places_[corner] + 1];
        std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
        corners_.resize(3 * surface_.triangles.size());
        std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
        for (std::size_t i = 0; i < surface_.triangles.size(); ++i)
            for (const std::uint32_t corner : surface_.triangles[i])
                corners_[next[places_[corner]]++] = static_cast<std::uint32_t>(i);
    }

    std::uint32_t vertexOf(std::uint32_t corner, std::uint32_t triangle) {
        const std::size_t start = starts_[places_[corner]];
        const std::size_t count = starts_[places_[corner] + 1] - start;
        const glm::vec3 positionM = surface_.positionsM[corner];
        if (count > kMostCornersOfPlace)
            return emit({positionM, glm::vec3(glm::normalize(areaNormals_[triangle]))});
        const std::span<const std::uint32_t> around(corners_.data() + start, count);
        const glm::vec3 normal = normalAmong(around, triangle);
        // Corners of one normal in one place are one vertex.
        for (std::size_t i = start; i < start + count; ++i) {
            if (emitted_[i] == kNone) return emitted_[i] = emit({positionM, normal});
            if (mesh_.vertices[emitted_[i]].normal == normal) return emitted_[i];
        }
        return emit({positionM, normal});
    }

    glm::vec3 normalAmong(std::span<const std::uint32_t> around, std::uint32_t triangle) const {
        const glm::dvec3 own = glm::normalize(areaNormals_[triangle]);
        glm::dvec3 sum(0.0);
        for (const std::uint32_t other : around) {
            const glm::dvec3& area = areaNormals_[other];
            if (isDirection(area) && glm::dot(own, area) >= kSmoothestEdge * glm::length(area)) sum += area;
        }
        return glm::vec3(isDirection(sum) ? glm::normalize(sum) : own);
    }

    std::uint32_t emit(const Vertex& vertex) {
        mesh_.vertices.push_back(vertex);
        return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
    }

    const MeshSurface& surface_;
    Mesh& mesh_;
    std::size_t placeCount_ = 0;
    std::vector<std::uint32_t> places_;    // By vertex of the surface.
    std::vector<glm::dvec3> areaNormals_;  // By triangle; as long as twice its area.
    std::vector<std::uint32_t> starts_;    // By place.
    std::vector<std::uint32_t> corners_;   // Triangles, sorted by place.
    std::vector<std::uint32_t> emitted_;   // Beside corners_: vertices that a place has got so far.
};

/// With its own normals, which also tell which side is the front: mirrored parts are wound the other way.
void appendWithNormals(const MeshSurface& surface, Mesh& mesh) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (std::size_t i = 0; i < surface.positionsM.size(); ++i) {
        const glm::dvec3 normal(surface.normals[i]);
        mesh.vertices.push_back(
            {surface.positionsM[i],
             glm::vec3(isDirection(normal) ? glm::normalize(normal) : glm::dvec3(0, 0, 1))});
    }
    for (const auto& [a, b, c] : surface.triangles) {
        const glm::dvec3 winding = areaNormal(surface, {a, b, c});
        if (!isDirection(winding)) continue;
        const glm::dvec3 normal(surface.normals[a] + surface.normals[b] + surface.normals[c]);
        const bool isTurned = glm::dot(winding, normal) < 0.0;
        mesh.indices.insert(mesh.indices.end(),
                            {first + a, first + (isTurned ? c : b), first + (isTurned ? b : c)});
    }
}

}  // namespace

void appendSurface(const MeshSurface& surface, Mesh& mesh) {
    if (!std::ranges::all_of(surface.positionsM, isFinite))
        throw RenderError("a vertex is not at a finite place");
    if (surface.normals.size() == surface.positionsM.size() && !surface.normals.empty()) {
        appendWithNormals(surface, mesh);
    } else {
        Smoother(surface, mesh).append();
    }
}

}  // namespace hazer::render
