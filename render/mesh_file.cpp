// Meshes from files, by Assimp.
#include <assimp/DefaultIOSystem.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "render/error.h"
#include "render/mesh.h"

namespace hazer::render {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxFileBytes = std::uintmax_t{256} << 20;
constexpr std::size_t kMaxVertices = 10'000'000;
/// Edges sharper than this stay edges where the file has no normals of its own.
constexpr float kSmoothingAngleDeg = 50.0f;

RenderError cannotReadMesh(const fs::path& file, std::string_view reason) {
    return RenderError(fmt::format("cannot read mesh '{}': {}", file.string(), reason));
}

/// What Assimp may open: the file itself, and files in its folder that it refers to (a glTF's buffers), of
/// bounded size. A mesh from a stranger must not read elsewhere.
class FolderOnly : public Assimp::DefaultIOSystem {
 public:
    explicit FolderOnly(const fs::path& file)
        : folder_(fs::weakly_canonical(fs::absolute(file)).parent_path()) {}

    bool Exists(const char* name) const override { return allowed(name) && DefaultIOSystem::Exists(name); }

    Assimp::IOStream* Open(const char* name, const char* mode) override {
        return allowed(name) ? DefaultIOSystem::Open(name, mode) : nullptr;
    }

 private:
    bool allowed(const char* name) const {
        std::error_code error;
        const fs::path file = fs::weakly_canonical(fs::absolute(name), error);
        if (error || !fs::is_regular_file(file, error)) return false;
        const auto [folderEnd, ignored] =
            std::mismatch(folder_.begin(), folder_.end(), file.begin(), file.end());
        return folderEnd == folder_.end() && fs::file_size(file, error) <= kMaxFileBytes && !error;
    }

    fs::path folder_;
};

/// The end of a name that tells its format, from its dot on. Some names are nothing else.
std::string lowerCaseEnd(const fs::path& file) {
    std::string end = file.extension().empty() ? file.filename().string() : file.extension().string();
    for (char& letter : end) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return end;
}

/// Metres per unit of the format: 3DS is written in millimetres on stages, everything else here in metres.
float metresPerUnit(const fs::path& file) {
    return lowerCaseEnd(file) == ".3ds" ? 1e-3f : 1.0f;
}

/// Assimp hands every format out with Y up and -Z away; here Z is up and +Y is away.
glm::vec3 zUpFromYUp(const aiVector3D& v) {
    return {v.x, -v.z, v.y};
}

bool isFinite(glm::vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

glm::vec3 unitNormal(const aiVector3D& v) {
    const glm::vec3 normal = zUpFromYUp(v);
    const float length = glm::length(normal);
    // A triangle without area has no normal, and nobody will see which one it gets.
    return length > 0.0f && std::isfinite(length) ? normal / length : glm::vec3(0, 0, 1);
}

void appendPart(Mesh& mesh, const aiMesh& part, float metres, const fs::path& file) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
        const glm::vec3 positionM = metres * zUpFromYUp(part.mVertices[i]);
        if (!isFinite(positionM)) throw cannotReadMesh(file, "a vertex is not at a finite place");
        mesh.vertices.push_back({positionM, unitNormal(part.mNormals[i])});
    }
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
        const aiFace& face = part.mFaces[i];
        for (unsigned corner = 0; corner < 3; ++corner) mesh.indices.push_back(first + face.mIndices[corner]);
    }
}

/// Mirrored parts come with their triangles turned around; the normals tell.
void windByNormals(Mesh& mesh) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vertex& a = mesh.vertices[mesh.indices[i]];
        const Vertex& b = mesh.vertices[mesh.indices[i + 1]];
        const Vertex& c = mesh.vertices[mesh.indices[i + 2]];
        const glm::vec3 winding = glm::cross(b.positionM - a.positionM, c.positionM - a.positionM);
        if (glm::dot(winding, a.normal + b.normal + c.normal) < 0.0f)
            std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    }
}

constexpr unsigned kSteps = aiProcess_ValidateDataStructure | aiProcess_Triangulate | aiProcess_SortByPType |
                            aiProcess_FindInvalidData | aiProcess_GenSmoothNormals |
                            aiProcess_PreTransformVertices | aiProcess_JoinIdenticalVertices;

Mesh meshOf(const Assimp::Importer& importer, const fs::path& file) {
    const aiScene* const scene = importer.GetScene();
    if (scene == nullptr) throw cannotReadMesh(file, importer.GetErrorString());
    std::size_t vertices = 0;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) vertices += scene->mMeshes[i]->mNumVertices;
    if (vertices > kMaxVertices)
        throw cannotReadMesh(file, fmt::format("it has more than {} vertices; simplify it", kMaxVertices));
    Mesh mesh;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i)
        appendPart(mesh, *scene->mMeshes[i], metresPerUnit(file), file);
    if (mesh.indices.empty()) throw cannotReadMesh(file, "there is no triangle in it");
    windByNormals(mesh);
    return mesh;
}

}  // namespace

Mesh loadMesh(const fs::path& file) {
    std::error_code error;
    if (!fs::is_regular_file(file, error)) throw cannotReadMesh(file, "there is no such file");
    const std::uintmax_t bytes = fs::file_size(file, error);
    if (error) throw cannotReadMesh(file, error.message());
    if (bytes > kMaxFileBytes) {
        throw cannotReadMesh(file, fmt::format("it is larger than {} MiB; simplify it", kMaxFileBytes >> 20));
    }
    Assimp::Importer importer;
    importer.SetIOHandler(new FolderOnly(file));  // The importer deletes it.
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, kSmoothingAngleDeg);
    importer.ReadFile(file.string(), kSteps);
    return meshOf(importer, file);
}

}  // namespace hazer::render
