#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>

#include "render/error.h"
#include "render/mesh.h"
#include "tests/support/mesh_bytes.h"
#include "tests/support/temporary_folder.h"

namespace hazer::render {
namespace {

namespace fs = std::filesystem;
using test::bytesOf;

class MeshFile : public testing::Test {
 protected:
    fs::path write(const std::string& name, std::string_view bytes) const {
        return folder_.write(fs::path("models") / name, bytes);
    }

    test::TemporaryFolder folder_;
};

std::string messageOf(const fs::path& file) {
    try {
        loadMesh(file);
    } catch (const RenderError& error) {
        return error.what();
    }
    return "no error";
}

/// A triangle in glTF's world (Y up, front +Z): it stands upright, 2 high and 1 wide, and looks to +Z.
std::string triangleBuffer() {
    return bytesOf<float>({0, 0, 0, 1, 0, 0, 0, 2, 0}) + bytesOf<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}) +
           bytesOf<std::uint16_t>({0, 1, 2});
}

std::string gltf(const std::string& uri, const std::string& nodeTransform) {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0)" +
           nodeTransform +
           R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1},"indices":2}]}],)"
           R"("buffers":[{"uri":")" +
           uri +
           R"(","byteLength":78}],"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":36},)"
           R"({"buffer":0,"byteOffset":72,"byteLength":6}],"accessors":[)"
           R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,2,0]},)"
           R"({"bufferView":1,"componentType":5126,"count":3,"type":"VEC3"},)"
           R"({"bufferView":2,"componentType":5123,"count":3,"type":"SCALAR"}]})";
}

/// A triangle that lies level at a height of 500 mm and looks up; 3DS has Z up.
std::string levelTriangle3ds() {
    return test::file3ds(test::object3ds({0, 0, 500, 1000, 0, 500, 0, 2000, 500}, {0, 1, 2, 7}));
}

bool hasVertex(const Mesh& mesh, glm::vec3 positionM) {
    for (const Vertex& vertex : mesh.vertices) {
        if (glm::distance(vertex.positionM, positionM) < 1e-5f) return true;
    }
    return false;
}

glm::vec3 windingOf(const Mesh& mesh) {
    const auto at = [&](std::size_t i) { return mesh.vertices[mesh.indices[i]].positionM; };
    return glm::normalize(glm::cross(at(1) - at(0), at(2) - at(0)));
}

TEST_F(MeshFile, GltfIsTurnedUpright) {
    write("triangle.bin", triangleBuffer());
    const Mesh mesh = loadMesh(write("a.gltf", gltf("triangle.bin", R"(,"translation":[0,10,0])")));
    ASSERT_EQ(mesh.indices.size(), 3u);
    EXPECT_TRUE(hasVertex(mesh, {0, 0, 10}));
    EXPECT_TRUE(hasVertex(mesh, {1, 0, 10}));
    EXPECT_TRUE(hasVertex(mesh, {0, 0, 12}));
    EXPECT_LT(glm::distance(mesh.vertices[0].normal, glm::vec3(0, -1, 0)), 1e-5f);
    EXPECT_LT(glm::distance(windingOf(mesh), glm::vec3(0, -1, 0)), 1e-5f);
}

TEST_F(MeshFile, MirroredPartKeepsItsFrontInFront) {
    write("triangle.bin", triangleBuffer());
    const Mesh mesh = loadMesh(write("a.gltf", gltf("triangle.bin", R"(,"scale":[-1,1,1])")));
    EXPECT_TRUE(hasVertex(mesh, {-1, 0, 0}));
    EXPECT_LT(glm::distance(windingOf(mesh), glm::vec3(0, -1, 0)), 1e-5f);
}

TEST_F(MeshFile, ThreeDsIsInMillimetresWithZUp) {
    const Mesh mesh = loadMesh(write("a.3DS", levelTriangle3ds()));
    ASSERT_EQ(mesh.indices.size(), 3u);
    EXPECT_TRUE(hasVertex(mesh, {0, 0, 0.5f}));
    EXPECT_TRUE(hasVertex(mesh, {1, 0, 0.5f}));
    EXPECT_TRUE(hasVertex(mesh, {0, 2, 0.5f}));
    EXPECT_LT(glm::distance(windingOf(mesh), glm::vec3(0, 0, 1)), 1e-5f);
}

TEST_F(MeshFile, BuffersOutsideTheFolderAreNotRead) {
    folder_.write("outside.bin", triangleBuffer());
    EXPECT_NE(messageOf(write("a.gltf", gltf("../outside.bin", ""))), "no error");
    EXPECT_NE(messageOf(write("b.gltf", gltf((folder_.path() / "outside.bin").string(), ""))), "no error");
}

TEST_F(MeshFile, ErrorsNameTheFileAndTheReason) {
    const fs::path missing = folder_.path() / "none.glb";
    EXPECT_NE(messageOf(missing).find(missing.string()), std::string::npos);
    EXPECT_NE(messageOf(missing).find("no such file"), std::string::npos);
    EXPECT_NE(messageOf(write("a.glb", "not a glb")), "no error");
    EXPECT_NE(messageOf(write("a.unknown", "x")), "no error");
    EXPECT_NE(messageOf(write("empty.obj", "v 0 0 0\n")), "no error");
}

TEST_F(MeshFile, PlaceThatIsNotFiniteIsRefused) {
    write("triangle.bin",
          bytesOf<float>({0, 0, 0, 1e30f, 0, 0, 0, std::numeric_limits<float>::infinity(), 0}) +
              bytesOf<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}) + bytesOf<std::uint16_t>({0, 1, 2}));
    EXPECT_NE(messageOf(write("a.gltf", gltf("triangle.bin", ""))), "no error");
}

TEST_F(MeshFile, EveryTruncatedPrefixIsRefusedOrReadWithoutHarm) {
    const std::string whole = levelTriangle3ds();
    for (std::size_t size = 0; size < whole.size(); ++size) {
        const std::string message = messageOf(write("a.3ds", std::string_view(whole).substr(0, size)));
        ASSERT_FALSE(message.empty());
    }
    const std::string text = gltf("triangle.bin", "");
    for (std::size_t size = 0; size < text.size(); size += 7) {
        ASSERT_NE(messageOf(write("a.gltf", std::string_view(text).substr(0, size))), "no error") << size;
    }
}

}  // namespace
}  // namespace hazer::render
