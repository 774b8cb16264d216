// A standing figure: five closed bodies of elliptic cross-sections that overlap at shoulders and hips.
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <span>

#include "render/mesh.h"
#include "render/mesh_builder.h"

namespace hazer::render {
namespace {

/// A level cross-section of a body; all in metres. Half widths are along X, half depths along Y.
struct Ring {
    float height;
    float x;
    float y;
    float halfWidth;
    float halfDepth;
};

// Proportions of an adult of 1.75 m. The first and the last ring of each body are points. The figure looks
// towards -Y.
constexpr Ring kTrunkAndHead[] = {
    {0.79f, 0, 0.00f, 0, 0},
    {0.81f, 0, 0.00f, 0.070f, 0.070f},
    {0.86f, 0, 0.008f, 0.155f, 0.105f},
    {0.92f, 0, 0.015f, 0.172f, 0.115f},
    {1.00f, 0, 0.01f, 0.165f, 0.110f},
    {1.08f, 0, 0.00f, 0.145f, 0.095f},
    {1.16f, 0, 0.00f, 0.147f, 0.100f},
    {1.25f, 0, 0.00f, 0.165f, 0.112f},
    {1.33f, 0, 0.00f, 0.182f, 0.115f},
    {1.39f, 0, 0.005f, 0.182f, 0.104f},
    {1.43f, 0, 0.010f, 0.160f, 0.080f},
    {1.46f, 0, 0.015f, 0.112f, 0.066f},
    {1.485f, 0, 0.013f, 0.074f, 0.061f},
    {1.51f, 0, 0.01f, 0.056f, 0.060f},
    {1.54f, 0, 0.00f, 0.056f, 0.072f},
    {1.56f, 0, -0.012f, 0.062f, 0.086f},
    {1.60f, 0, -0.01f, 0.073f, 0.096f},
    {1.65f, 0, 0.00f, 0.079f, 0.101f},
    {1.70f, 0, 0.003f, 0.075f, 0.093f},
    {1.73f, 0, 0.005f, 0.056f, 0.069f},
    {1.745f, 0, 0.005f, 0.030f, 0.037f},
    {1.75f, 0, 0.005f, 0, 0},
};
constexpr Ring kArm[] = {
    {0.675f, 0.290f, -0.060f, 0, 0},          {0.69f, 0.291f, -0.059f, 0.012f, 0.022f},
    {0.74f, 0.295f, -0.054f, 0.019f, 0.037f}, {0.80f, 0.294f, -0.044f, 0.023f, 0.043f},
    {0.85f, 0.289f, -0.037f, 0.024f, 0.034f}, {0.89f, 0.284f, -0.030f, 0.026f, 0.029f},
    {0.97f, 0.272f, -0.013f, 0.035f, 0.037f}, {1.06f, 0.256f, 0.004f, 0.042f, 0.046f},
    {1.12f, 0.244f, 0.012f, 0.042f, 0.047f},  {1.20f, 0.228f, 0.012f, 0.045f, 0.051f},
    {1.30f, 0.207f, 0.010f, 0.053f, 0.060f},  {1.37f, 0.188f, 0.009f, 0.059f, 0.066f},
    {1.415f, 0.165f, 0.010f, 0.056f, 0.058f}, {1.44f, 0.140f, 0.012f, 0.038f, 0.040f},
    {1.445f, 0.130f, 0.012f, 0, 0},
};
constexpr Ring kLeg[] = {
    {0.00f, 0.130f, -0.055f, 0, 0},           {0.004f, 0.130f, -0.055f, 0.044f, 0.126f},
    {0.03f, 0.129f, -0.053f, 0.047f, 0.128f}, {0.055f, 0.127f, -0.035f, 0.043f, 0.102f},
    {0.08f, 0.124f, -0.004f, 0.037f, 0.060f}, {0.14f, 0.121f, 0.012f, 0.034f, 0.042f},
    {0.24f, 0.117f, 0.014f, 0.045f, 0.052f},  {0.34f, 0.113f, 0.015f, 0.055f, 0.063f},
    {0.42f, 0.110f, 0.005f, 0.053f, 0.060f},  {0.49f, 0.107f, -0.005f, 0.056f, 0.062f},
    {0.58f, 0.103f, 0.000f, 0.064f, 0.072f},  {0.70f, 0.097f, 0.005f, 0.077f, 0.088f},
    {0.82f, 0.092f, 0.010f, 0.085f, 0.099f},  {0.89f, 0.086f, 0.012f, 0.074f, 0.088f},
    {0.95f, 0.080f, 0.012f, 0.045f, 0.055f},  {0.98f, 0.076f, 0.012f, 0, 0},
};
constexpr std::uint32_t kTrunkSegments = 16;
constexpr std::uint32_t kLimbSegments = 10;

/// A band of triangles between two rings of vertices, the lower one first.
void appendBand(Mesh& mesh, std::uint32_t lower, std::uint32_t upper, std::uint32_t segments) {
    for (std::uint32_t i = 0; i < segments; ++i) {
        const std::uint32_t next = (i + 1) % segments;
        appendTriangle(mesh, lower + i, lower + next, upper + next);
        appendTriangle(mesh, lower + i, upper + next, upper + i);
    }
}

void appendRing(Mesh& mesh, const Ring& ring, float side, std::uint32_t segments) {
    for (std::uint32_t i = 0; i < segments; ++i) {
        const float azimuthRad = glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(segments);
        const glm::vec3 positionM(side * ring.x + ring.halfWidth * std::cos(azimuthRad),
                                  ring.y + ring.halfDepth * std::sin(azimuthRad), ring.height);
        mesh.vertices.push_back({positionM, glm::vec3(0)});
    }
}

/// Normals as the mean of the triangles around each place, weighted with their areas. Vertices of a pole are
/// one place.
void smoothNormals(Mesh& mesh, std::uint32_t segments) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        Vertex& a = mesh.vertices[mesh.indices[i]];
        Vertex& b = mesh.vertices[mesh.indices[i + 1]];
        Vertex& c = mesh.vertices[mesh.indices[i + 2]];
        const glm::vec3 areaNormal = glm::cross(b.positionM - a.positionM, c.positionM - a.positionM);
        for (Vertex* corner : {&a, &b, &c}) corner->normal += areaNormal;
    }
    for (std::uint32_t i = 0; i < segments; ++i) {
        mesh.vertices[i].normal = glm::vec3(0, 0, -1);
        mesh.vertices[vertexCount(mesh) - 1 - i].normal = glm::vec3(0, 0, 1);
    }
    for (Vertex& vertex : mesh.vertices) vertex.normal = glm::normalize(vertex.normal);
}

/// A closed body through rings from the lowest to the highest. `side` is +1 or -1: limbs of the +X or the -X
/// side.
Mesh makeBody(std::span<const Ring> rings, float side, std::uint32_t segments) {
    Mesh body;
    for (const Ring& ring : rings) appendRing(body, ring, side, segments);
    for (std::uint32_t i = 0; i + 1 < rings.size(); ++i)
        appendBand(body, i * segments, (i + 1) * segments, segments);
    smoothNormals(body, segments);
    return body;
}

}  // namespace

Mesh makePerson() {
    Mesh person = makeBody(kTrunkAndHead, 1.0f, kTrunkSegments);
    for (const float side : {-1.0f, 1.0f}) {
        appendTransformed(person, makeBody(kArm, side, kLimbSegments), glm::mat4(1.0f));
        appendTransformed(person, makeBody(kLeg, side, kLimbSegments), glm::mat4(1.0f));
    }
    return person;
}

}  // namespace hazer::render
