// An .mvr archive or the XML of a scene may hold anything: it becomes a scene with finite poses, or a
// ParseError and nothing else.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string_view>

#include "fixtures/mvr.h"
#include "fixtures/parse_error.h"

namespace {

using namespace hazer::fixtures;

void require(bool holds) {
    if (!holds) std::abort();
}

bool isPlaced(const glm::dmat4& pose) {
    return glm::length(glm::dvec3(pose[3])) < 1e6;  // not of NaN
}

void check(const MvrScene& scene) {
    for (const MvrObject& object : scene.objects) {
        require(object.parent < static_cast<int>(scene.objects.size()));
        require(isPlaced(object.worldFromObject));
        for (const MvrMesh& mesh : object.meshes) {
            require(mesh.file >= 0 && static_cast<std::size_t>(mesh.file) < scene.meshFiles.size());
            require(isPlaced(mesh.worldFromMesh));
        }
        if (!object.device) continue;
        for (const MvrAddress& address : object.device->addresses) {
            require(address.slot >= 1 && address.slot <= kSlotsPerUniverse && address.universe >= 1);
        }
    }
}

void readAll(MvrArchive& archive) {
    const MvrScene scene = archive.readScene();
    check(scene);
    for (const std::string& name : scene.meshFiles) {
        const auto entry = archive.find(name, {".3ds", ".glb"});
        if (entry) archive.read(*entry, std::size_t{1} << 20);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        if (text.starts_with("PK")) {
            MvrArchive archive({data, data + size}, "fuzz.mvr");
            readAll(archive);
        } else {
            check(parseMvrScene(text, "fuzz.xml"));
        }
    } catch (const ParseError&) {
        // The answer to a broken file.
    }
    return 0;
}
