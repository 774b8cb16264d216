#include "render/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <map>
#include <tuple>
#include <utility>

namespace hazer::render {
namespace {

struct Extent {
    glm::vec3 lowM{1e9f};
    glm::vec3 highM{-1e9f};
};

Extent extentOf(const Mesh& mesh) {
    Extent extent;
    for (const Vertex& vertex : mesh.vertices) {
        extent.lowM = glm::min(extent.lowM, vertex.positionM);
        extent.highM = glm::max(extent.highM, vertex.positionM);
    }
    return extent;
}

/// Volume enclosed by a closed mesh, by the divergence theorem; negative if it is inside out.
double signedVolumeM3(const Mesh& mesh) {
    double volume = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a = mesh.vertices[mesh.indices[i]].positionM;
        const glm::dvec3 b = mesh.vertices[mesh.indices[i + 1]].positionM;
        const glm::dvec3 c = mesh.vertices[mesh.indices[i + 2]].positionM;
        volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return volume;
}

using Place = std::tuple<long, long, long>;

Place placeOf(const Vertex& vertex) {
    const glm::dvec3 rounded = glm::round(glm::dvec3(vertex.positionM) * 1e5);
    return {static_cast<long>(rounded.x), static_cast<long>(rounded.y), static_cast<long>(rounded.z)};
}

/// Edges that are not walked once in each direction: none in a closed mesh that is wound alike everywhere.
std::size_t openEdges(const Mesh& mesh) {
    std::map<std::pair<Place, Place>, int> balance;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
        const Place a = placeOf(mesh.vertices[mesh.indices[i]]);
        const Place b = placeOf(mesh.vertices[mesh.indices[next]]);
        balance[std::minmax(a, b)] += a < b ? 1 : -1;
    }
    return static_cast<std::size_t>(
        std::count_if(balance.begin(), balance.end(), [](const auto& edge) { return edge.second != 0; }));
}

void expectSound(const Mesh& mesh) {
    ASSERT_FALSE(mesh.indices.empty());
    ASSERT_EQ(mesh.indices.size() % 3, 0u);
    ASSERT_LT(*std::max_element(mesh.indices.begin(), mesh.indices.end()), mesh.vertices.size());
    for (const Vertex& vertex : mesh.vertices) ASSERT_NEAR(glm::length(vertex.normal), 1.0f, 1e-4f);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vertex& a = mesh.vertices[mesh.indices[i]];
        const Vertex& b = mesh.vertices[mesh.indices[i + 1]];
        const Vertex& c = mesh.vertices[mesh.indices[i + 2]];
        const glm::vec3 winding = glm::cross(b.positionM - a.positionM, c.positionM - a.positionM);
        ASSERT_GT(glm::length(winding), 0.0f) << "triangle " << i / 3;
        ASSERT_GT(glm::dot(winding, a.normal + b.normal + c.normal), 0.0f)
            << "triangle " << i / 3 << " at " << a.positionM.x << ' ' << a.positionM.y << ' '
            << a.positionM.z;
    }
}

void expectClosed(const Mesh& mesh) {
    expectSound(mesh);
    EXPECT_EQ(openEdges(mesh), 0u);
    EXPECT_GT(signedVolumeM3(mesh), 0.0);
}

TEST(Shapes, BoxIsTheUnitCube) {
    const Mesh box = makeBox();
    expectClosed(box);
    EXPECT_NEAR(signedVolumeM3(box), 1.0, 1e-6);
    EXPECT_EQ(box.indices.size(), 36u);
    EXPECT_EQ(extentOf(box).lowM, glm::vec3(-0.5f));
    EXPECT_EQ(extentOf(box).highM, glm::vec3(0.5f));
}

TEST(Shapes, CylinderStandsAlongZ) {
    const Mesh cylinder = makeCylinder();
    expectClosed(cylinder);
    EXPECT_NEAR(signedVolumeM3(cylinder), glm::pi<double>() / 4.0, 0.01 * glm::pi<double>() / 4.0);
    EXPECT_NEAR(extentOf(cylinder).highM.z, 0.5f, 1e-6f);
    EXPECT_NEAR(extentOf(cylinder).lowM.z, -0.5f, 1e-6f);
}

TEST(Shapes, SphereHasTheVolumeOfASphere) {
    const Mesh sphere = makeSphere();
    expectClosed(sphere);
    EXPECT_NEAR(signedVolumeM3(sphere), glm::pi<double>() / 6.0, 0.02 * glm::pi<double>() / 6.0);
    for (const Vertex& vertex : sphere.vertices) {
        ASSERT_NEAR(glm::length(vertex.positionM), 0.5f, 1e-6f);
        ASSERT_NEAR(glm::dot(vertex.normal, vertex.positionM), 0.5f, 1e-6f);
    }
}

TEST(Shapes, PlaneLooksUp) {
    const Mesh plane = makePlane();
    expectSound(plane);
    for (const Vertex& vertex : plane.vertices) EXPECT_EQ(vertex.normal, glm::vec3(0, 0, 1));
    EXPECT_EQ(extentOf(plane).lowM, glm::vec3(-0.5f, -0.5f, 0.0f));
    EXPECT_EQ(extentOf(plane).highM, glm::vec3(0.5f, 0.5f, 0.0f));
}

TEST(Shapes, TrussIsAsLongAndWideAsAsked) {
    for (const double lengthM : {0.2, 2.0, 12.0}) {
        const Mesh truss = makeTruss(lengthM, 0.29);
        expectClosed(truss);
        const Extent extent = extentOf(truss);
        EXPECT_NEAR(extent.highM.x - extent.lowM.x, lengthM, 0.03);
        EXPECT_NEAR(extent.highM.y - extent.lowM.y, 0.29, 0.01);
        EXPECT_NEAR(extent.highM.z - extent.lowM.z, 0.29, 0.01);
        EXPECT_NEAR(extent.highM.x, -extent.lowM.x, 1e-4);
    }
}

TEST(Shapes, TrussIsMostlyAir) {
    const Mesh truss = makeTruss(2.0, 0.29);
    const double share = signedVolumeM3(truss) / (2.0 * 0.29 * 0.29);
    EXPECT_GT(share, 0.05);
    EXPECT_LT(share, 0.15);
}

TEST(Shapes, TrussOfAnyLengthHasBoundedLacing) {
    EXPECT_LT(makeTruss(1e5, 1e-5).indices.size(), 1'000'000u);
}

TEST(Shapes, PersonStandsOnTheFloorAndLooksTowardsTheAudience) {
    const Mesh person = makePerson();
    expectClosed(person);
    const Extent extent = extentOf(person);
    EXPECT_NEAR(extent.lowM.z, 0.0f, 1e-6f);
    EXPECT_NEAR(extent.highM.z, 1.75f, 1e-6f);
    EXPECT_NEAR(extent.highM.x, -extent.lowM.x, 1e-5f);
    EXPECT_LT(extent.highM.x - extent.lowM.x, 0.8f);
    // The toes reach further to the front than the heels to the back.
    EXPECT_GT(-extent.lowM.y, extent.highM.y + 0.02f);
    EXPECT_GE(person.indices.size() / 3, 500u);
    EXPECT_LE(person.indices.size() / 3, 2000u);
    // A grown-up weighs about as much as as much water.
    EXPECT_NEAR(signedVolumeM3(person), 0.075, 0.015);
}

TEST(Shapes, TeapotIsAMetreHighWithItsSpoutToTheRight) {
    const Mesh teapot = makeTeapot();
    expectSound(teapot);
    const Extent extent = extentOf(teapot);
    EXPECT_NEAR(extent.lowM.z, 0.0f, 1e-6f);
    EXPECT_NEAR(extent.highM.z, 1.0f, 1e-6f);
    // Newell's curves end at x = 3.434 (spout) and -3.0 (handle), and the body is 4 wide, of 3.15.
    EXPECT_NEAR(extent.highM.x, 3.434f / 3.15f, 0.003f);
    EXPECT_NEAR(extent.lowM.x, -3.0f / 3.15f, 0.003f);
    EXPECT_NEAR(extent.highM.y, 2.0f / 3.15f, 0.01f);
    EXPECT_NEAR(extent.highM.y, -extent.lowM.y, 1e-5f);
}

TEST(Shapes, TeapotLooksOutwards) {
    const Mesh teapot = makeTeapot();
    EXPECT_GT(signedVolumeM3(teapot), 0.0);
    for (const Vertex& vertex : teapot.vertices) {
        const glm::vec3& p = vertex.positionM;
        const float axisDistanceM = glm::length(glm::vec2(p));
        if (axisDistanceM < 1e-3f) {
            ASSERT_NEAR(vertex.normal.z, p.z > 0.5f ? 1.0f : -1.0f, 0.02f);
        } else if (p.z > 0.1f && p.z < 0.7f && std::abs(p.y) > 0.3f) {
            ASSERT_GT(glm::dot(glm::vec2(vertex.normal), glm::vec2(p)), 0.0f);
        } else if (p.x > 1.05f && p.z < 0.75f) {
            ASSERT_LT(vertex.normal.z, 0.0f) << "under the lip of the spout";
        }
    }
}

TEST(BoundingSphere, HoldsEveryVertexAndIsTightForASphere) {
    for (const Mesh& mesh : {makeBox(), makeTeapot(), makePerson(), makeTruss(3.0, 0.3)}) {
        const BoundingSphere sphere = boundingSphere(mesh);
        for (const Vertex& vertex : mesh.vertices) {
            ASSERT_LE(glm::distance(vertex.positionM, sphere.centerM), sphere.radiusM * 1.000001f);
        }
    }
    EXPECT_NEAR(boundingSphere(makeSphere()).radiusM, 0.5f, 1e-5f);
    EXPECT_NEAR(boundingSphere(makeBox()).radiusM, std::sqrt(0.75f), 1e-5f);
    EXPECT_EQ(boundingSphere(Mesh{}).radiusM, 0.0f);
}

}  // namespace
}  // namespace hazer::render
