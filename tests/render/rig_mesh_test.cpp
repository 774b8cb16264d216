// Meshes of strangers: what is read of 3DS and glTF, and what becomes of broken ones.
#include "render/rig_mesh.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "render/error.h"
#include "tests/support/mesh_bytes.h"

namespace hazer::render {
namespace {

using test::bytesOf;
using test::chunk3ds;
using test::file3ds;
using test::object3ds;
using ::testing::HasSubstr;
using ::testing::SizeIs;

std::vector<PaintedMesh> parse(const std::string& bytes, const std::string& name) {
    // A block of its exact size, so that a sanitizer sees a byte read too far.
    const std::vector<std::uint8_t> block(bytes.begin(), bytes.end());
    return parseRigMesh(block, name);
}

Mesh meshOf(const std::string& bytes, const std::string& name) {
    return parse(bytes, name).at(0).mesh;
}

std::string errorOf(const std::string& bytes, const std::string& name) {
    try {
        parse(bytes, name);
    } catch (const RenderError& error) {
        return error.what();
    }
    return "no error";
}

bool hasPlace(const Mesh& mesh, glm::vec3 positionM) {
    for (const Vertex& vertex : mesh.vertices) {
        if (glm::distance(vertex.positionM, positionM) < 1e-5f) return true;
    }
    return false;
}

glm::vec3 frontOf(const Mesh& mesh) {
    const auto at = [&](std::size_t i) { return mesh.vertices[mesh.indices[i]].positionM; };
    return glm::normalize(glm::cross(at(1) - at(0), at(2) - at(0)));
}

/// Level at a height of 500 mm, looking up.
std::string triangle3ds() {
    return file3ds(object3ds({0, 0, 500, 1000, 0, 500, 0, 2000, 500}, {0, 1, 2, 7}));
}

struct Glb {
    std::string node = R"({"mesh":0})";
    std::string primitive = R"("attributes":{"POSITION":0,"NORMAL":1},"indices":2)";
    std::string root;  ///< Further members.
    /// A triangle that stands upright, 2 high and 1 wide, and looks to +Z, where glTF has its front.
    std::string buffer = bytesOf<float>({0, 0, 0, 1, 0, 0, 0, 2, 0}) +
                         bytesOf<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}) + bytesOf<std::uint16_t>({0, 1, 2});
    std::string count = "3";

    std::string bytes() const {
        return test::glbOf(
            R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)" + node +
                R"(],"meshes":[{"primitives":[{)" + primitive + R"(}]}],"buffers":[{"byteLength":78}],)" +
                R"("bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":36},)"
                R"({"buffer":0,"byteOffset":72,"byteLength":6}],"accessors":[)"
                R"({"bufferView":0,"componentType":5126,"count":)" +
                count +
                R"(,"type":"VEC3"},{"bufferView":1,"componentType":5126,"count":3,"type":"VEC3"},)"
                R"({"bufferView":2,"componentType":5123,"count":3,"type":"SCALAR"}])" +
                root + "}",
            buffer);
    }
};

TEST(RigMesh, ThreeDsIsInMillimetresWithZUp) {
    const Mesh mesh = meshOf(triangle3ds(), "bar.3ds");
    EXPECT_TRUE(hasPlace(mesh, {1.0f, 0.0f, 0.5f}));
    EXPECT_TRUE(hasPlace(mesh, {0.0f, 2.0f, 0.5f}));
    EXPECT_LT(glm::distance(frontOf(mesh), glm::vec3(0, 0, 1)), 1e-5f);
    EXPECT_LT(glm::distance(mesh.vertices[0].normal, glm::vec3(0, 0, 1)), 1e-5f);
    EXPECT_TRUE(hasPlace(meshOf(triangle3ds(), ".3DS"), {1.0f, 0.0f, 0.5f})) << "a name that is only its end";
}

TEST(RigMesh, GltfIsInMetresAndTurnedUpright) {
    const Mesh mesh = meshOf(Glb().bytes(), "wall.glb");
    EXPECT_TRUE(hasPlace(mesh, {1.0f, 0.0f, 0.0f}));
    EXPECT_TRUE(hasPlace(mesh, {0.0f, 0.0f, 2.0f}));
    EXPECT_LT(glm::distance(frontOf(mesh), glm::vec3(0, -1, 0)), 1e-5f);
    EXPECT_LT(glm::distance(mesh.vertices[0].normal, glm::vec3(0, -1, 0)), 1e-5f);
}

TEST(RigMesh, NodesAreMovedTurnedAndScaled) {
    Glb glb;
    glb.node = R"({"children":[1],"translation":[0,10,0]},{"mesh":0,"scale":[-3,1,1]})";
    const Mesh mirrored = meshOf(glb.bytes(), "a.glb");
    EXPECT_TRUE(hasPlace(mirrored, {-3.0f, 0.0f, 10.0f}));
    EXPECT_LT(glm::distance(frontOf(mirrored), glm::vec3(0, -1, 0)), 1e-5f) << "its front stays in front";
    glb.node = R"({"mesh":0,"matrix":[0,1,0,0,-1,0,0,0,0,0,1,0,5,0,0,1]})";
    EXPECT_TRUE(hasPlace(meshOf(glb.bytes(), "a.glb"), {5.0f, 0.0f, 1.0f})) << "X became Y";
    glb.node = R"({"mesh":0,"rotation":[0,0,0.7071068,0.7071068]})";
    EXPECT_TRUE(hasPlace(meshOf(glb.bytes(), "a.glb"), {0.0f, 0.0f, 1.0f}));
}

TEST(RigMesh, IndicesNormalsAndModesAreOptional) {
    Glb glb;
    for (const char* primitive :
         {R"("attributes":{"POSITION":0})", R"("attributes":{"POSITION":0},"mode":5)",
          R"("attributes":{"POSITION":0},"mode":6)", R"("attributes":{"POSITION":0},"indices":2)"}) {
        glb.primitive = primitive;
        const Mesh mesh = meshOf(glb.bytes(), "a.glb");
        EXPECT_THAT(mesh.indices, SizeIs(3)) << primitive;
        EXPECT_LT(glm::distance(mesh.vertices[0].normal, glm::vec3(0, -1, 0)), 1e-5f) << primitive;
    }
}

TEST(RigMesh, SurfacesHaveTheirPaint) {
    const std::string red =
        chunk3ds(0xAFFF, chunk3ds(0xA000, std::string("red\0", 4)) +
                             chunk3ds(0xA020, chunk3ds(0x0011, std::string("\xFF\0\0", 3))));
    const std::string secondFace = chunk3ds(0x4130, std::string("red\0", 4) + bytesOf<std::uint16_t>({1, 1}));
    const std::string object =
        object3ds({0, 0, 0, 1000, 0, 0, 0, 1000, 0, 0, 0, 1000}, {0, 1, 2, 7, 0, 1, 3, 7}, secondFace);
    for (const std::string& content : {red + object, object + red}) {
        const std::vector<PaintedMesh> meshes = parse(file3ds(content), "a.3ds");
        ASSERT_THAT(meshes, SizeIs(2));
        EXPECT_FALSE(meshes[0].paint);
        EXPECT_EQ(meshes[1].paint, glm::vec3(1, 0, 0));
        EXPECT_TRUE(hasPlace(meshes[1].mesh, {0.0f, 0.0f, 1.0f}));
        EXPECT_FALSE(hasPlace(meshes[0].mesh, {0.0f, 0.0f, 1.0f}));
    }
    Glb glb;
    glb.primitive += R"(,"material":0)";
    glb.root = R"(,"materials":[{"pbrMetallicRoughness":{"baseColorFactor":[0,0.5,1,1]}}])";
    EXPECT_EQ(parse(glb.bytes(), "a.glb").at(0).paint, glm::vec3(0.0f, 0.5f, 1.0f));
}

TEST(RigMesh, BluntEdgesAreSmoothAndSharpOnesStay) {
    const auto roof = [](float ridgeMm) {
        return meshOf(file3ds(object3ds({0, -1000, 0, 1000, 0, ridgeMm, 0, 0, ridgeMm, 0, 1000, 0},
                                        {0, 1, 2, 7, 2, 1, 3, 7})),
                      "roof.3ds");
    };
    const Mesh flat = roof(200.0f);
    EXPECT_THAT(flat.vertices, SizeIs(4)) << "the ridge is shared";
    const Mesh steep = roof(2000.0f);
    EXPECT_THAT(steep.vertices, SizeIs(6)) << "the ridge is an edge";
}

TEST(RigMesh, OtherFormatsAndOtherFilesAreNotRead) {
    const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    EXPECT_THAT(errorOf(obj, "a.obj"), HasSubstr("'a.obj': it is neither"));
    EXPECT_THAT(errorOf(obj, "a.3ds"), HasSubstr("no 3DS"));
    EXPECT_THAT(errorOf(obj, "a.glb"), HasSubstr("no binary glTF"));
    EXPECT_NE(errorOf("", "a"), "no error");
    Glb glb;
    std::string bytes = glb.bytes();
    bytes.replace(bytes.find(R"("byteLength":78)"), 15, R"("uri":"/etc/x" )");
    EXPECT_THAT(errorOf(bytes, "a.glb"), HasSubstr("another file"));
}

TEST(RigMesh, LiesAreRefused) {
    Glb glb;
    for (const char* count : {"4", "400000000", "18446744073709551615", "-1", "3.5", "\"3\"", "null"}) {
        glb.count = count;
        EXPECT_NE(errorOf(glb.bytes(), "a.glb"), "no error") << count;
    }
    glb = {};
    glb.node = R"({"mesh":0,"children":[0]})";
    EXPECT_THAT(errorOf(glb.bytes(), "a.glb"), HasSubstr("in themselves"));
    glb = {};
    glb.buffer.replace(72, 2, "\xFF\xFF");
    EXPECT_THAT(errorOf(glb.bytes(), "a.glb"), HasSubstr("corner that is not there"));
    glb = {};
    glb.root = R"(,"extensionsRequired":["KHR_draco_mesh_compression"])";
    EXPECT_THAT(errorOf(glb.bytes(), "a.glb"), HasSubstr("without compression"));
    glb.root = ",\"extras\":" + std::string(100, '[') + std::string(100, ']');
    EXPECT_THAT(errorOf(glb.bytes(), "a.glb"), HasSubstr("nested too deep"));
    EXPECT_THAT(errorOf(file3ds(object3ds({0, 0, 0}, {0, 0, 1, 7})), "a.3ds"),
                HasSubstr("corner that is not there"));
    EXPECT_THAT(errorOf(file3ds(object3ds({0, 0, 0}, {0, 0, 0, 7})), "a.3ds"), HasSubstr("no triangle"));
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    EXPECT_THAT(errorOf(file3ds(object3ds({0, 0, 0, 1, 0, 0, 0, kInfinity, 0}, {0, 1, 2, 7})), "a.3ds"),
                HasSubstr("finite place"));
}

TEST(RigMesh, WhatIsTooMuchIsRefused) {
    Glb glb;
    glb.node = R"({"children":[1,1,1,1,1,1,1,1]},)";
    for (int level = 2; level < 20; ++level) {
        glb.node += fmt::format(R"({{"children":[{0},{0},{0},{0},{0},{0},{0},{0}]}},)", level);
    }
    glb.node += R"({"mesh":0})";
    EXPECT_THAT(errorOf(glb.bytes(), "a.glb"), HasSubstr("it has too many"));
}

TEST(RigMesh, EveryPrefixIsReadOrRefused) {
    for (const auto& [bytes, name] : {std::pair(triangle3ds(), "a.3ds"), std::pair(Glb().bytes(), "a.glb")}) {
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            EXPECT_FALSE(errorOf(bytes.substr(0, size), name).empty());
        }
    }
}

}  // namespace
}  // namespace hazer::render
