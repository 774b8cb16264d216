#include "render/rig_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

#include "render/error.h"
#include "render/mesh_3ds.h"
#include "render/mesh_glb.h"
#include "render/mesh_surface.h"

namespace hazer::render {
namespace {

/// Each is an instance of its own to draw.
constexpr std::size_t kMostPaints = 4;

bool endsIgnoringCase(std::string_view text, std::string_view end) {
    if (text.size() < end.size()) return false;
    return std::ranges::equal(text.substr(text.size() - end.size()), end, [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == b;
    });
}

std::vector<MeshSurface> readSurfaces(std::span<const std::uint8_t> bytes, const std::string& name) {
    if (endsIgnoringCase(name, ".3ds")) return read3ds(bytes);
    if (endsIgnoringCase(name, ".glb")) return readGlb(bytes);
    throw RenderError("it is neither a .3ds nor a .glb");
}

Mesh& meshOfPaint(const std::optional<glm::vec3>& paint, std::vector<PaintedMesh>& meshes) {
    const auto found = std::ranges::find(meshes, paint, &PaintedMesh::paint);
    if (found != meshes.end()) return found->mesh;
    if (meshes.size() == kMostPaints) return meshes.front().mesh;
    return meshes.emplace_back(PaintedMesh{{}, paint}).mesh;
}

}  // namespace

std::vector<PaintedMesh> parseRigMesh(std::span<const std::uint8_t> bytes, const std::string& name) {
    try {
        std::vector<PaintedMesh> meshes;
        for (const MeshSurface& surface : readSurfaces(bytes, name))
            appendSurface(surface, meshOfPaint(surface.paint, meshes));
        std::erase_if(meshes, [](const PaintedMesh& painted) { return painted.mesh.indices.empty(); });
        if (meshes.empty()) throw RenderError("there is no triangle in it");
        return meshes;
    } catch (const RenderError& error) {
        throw RenderError(fmt::format("cannot read mesh '{}': {}", name, error.what()));
    }
}

}  // namespace hazer::render
