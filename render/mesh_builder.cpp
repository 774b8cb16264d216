#include "render/mesh_builder.h"

#include <cassert>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace hazer::render {
namespace {

/// Corners nearer than this are one point: far below what can be seen, far above the rounding of metre-sized
/// shapes.
constexpr float kSamePointM = 1e-6f;

/// Rotation that takes +Z to a unit direction.
glm::mat3 rotationFromZ(glm::vec3 direction) {
    const glm::vec3 helper = std::abs(direction.z) < 0.9f ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0);
    const glm::vec3 x = glm::normalize(glm::cross(helper, direction));
    return {x, glm::cross(direction, x), direction};
}

}  // namespace

void appendTriangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto same = [&](std::uint32_t i, std::uint32_t j) {
        return glm::distance(mesh.vertices[i].positionM, mesh.vertices[j].positionM) < kSamePointM;
    };
    if (same(a, b) || same(b, c) || same(c, a)) return;
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

void appendSurface(Mesh& mesh, int columns, int rows, const Surface& surface) {
    const std::uint32_t first = vertexCount(mesh);
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            mesh.vertices.push_back(surface(static_cast<float>(column) / static_cast<float>(columns),
                                            static_cast<float>(row) / static_cast<float>(rows)));
        }
    }
    const auto stride = static_cast<std::uint32_t>(columns) + 1;
    for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(rows); ++row) {
        for (std::uint32_t column = 0; column < static_cast<std::uint32_t>(columns); ++column) {
            const std::uint32_t corner = first + row * stride + column;
            appendTriangle(mesh, corner, corner + 1, corner + stride + 1);
            appendTriangle(mesh, corner, corner + stride + 1, corner + stride);
        }
    }
}

void appendConeBand(Mesh& mesh, ProfilePoint from, ProfilePoint to, int segments) {
    const glm::vec2 along = glm::normalize(glm::vec2(to.radiusM - from.radiusM, to.heightM - from.heightM));
    appendSurface(mesh, segments, 1, [&](float u, float v) {
        const float azimuthRad = u * glm::two_pi<float>();
        const glm::vec3 outwards(std::cos(azimuthRad), std::sin(azimuthRad), 0.0f);
        const float radiusM = glm::mix(from.radiusM, to.radiusM, v);
        const float heightM = glm::mix(from.heightM, to.heightM, v);
        return Vertex{outwards * radiusM + glm::vec3(0, 0, heightM),
                      outwards * along.y - glm::vec3(0, 0, along.x)};
    });
}

void appendBar(Mesh& mesh, glm::vec3 fromM, glm::vec3 toM, float radiusM, int segments) {
    const float lengthM = glm::distance(fromM, toM);
    assert(lengthM > 0.0f);
    Mesh bar;
    appendConeBand(bar, {0.0f, 0.0f}, {radiusM, 0.0f}, segments);
    appendConeBand(bar, {radiusM, 0.0f}, {radiusM, lengthM}, segments);
    appendConeBand(bar, {radiusM, lengthM}, {0.0f, lengthM}, segments);
    glm::mat4 meshFromBar(rotationFromZ((toM - fromM) / lengthM));
    meshFromBar[3] = glm::vec4(fromM, 1.0f);
    appendTransformed(mesh, bar, meshFromBar);
}

void appendTransformed(Mesh& mesh, const Mesh& part, const glm::mat4& meshFromPart) {
    assert(glm::determinant(glm::mat3(meshFromPart)) > 0.0f);
    const glm::mat3 normalFromPart = glm::transpose(glm::inverse(glm::mat3(meshFromPart)));
    const std::uint32_t first = vertexCount(mesh);
    for (const Vertex& vertex : part.vertices) {
        mesh.vertices.push_back({glm::vec3(meshFromPart * glm::vec4(vertex.positionM, 1.0f)),
                                 glm::normalize(normalFromPart * vertex.normal)});
    }
    for (const std::uint32_t index : part.indices) mesh.indices.push_back(first + index);
}

}  // namespace hazer::render
