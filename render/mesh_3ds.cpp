#include "render/mesh_3ds.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace hazer::render {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr float kMetresPerUnit = 1e-3f;
/// Objects without triangles cost no budget, but time.
constexpr std::size_t kMostChunks = 500'000;

// Chunks: what they hold, and what they lie in.
enum Chunk : std::uint16_t {
    kFile = 0x4D4D,
    kEditor = 0x3D3D,    // in kFile
    kMaterial = 0xAFFF,  // in kEditor
    kMaterialName = 0xA000,
    kDiffuse = 0xA020,
    kFloatColor = 0x0010,  // in kDiffuse, as the next three
    kByteColor = 0x0011,
    kLinearByteColor = 0x0012,
    kLinearFloatColor = 0x0013,
    kObject = 0x4000,  // in kEditor, after its name
    kMesh = 0x4100,
    kVertices = 0x4110,
    kFaces = 0x4120,
    kFaceMaterial = 0x4130  // in kFaces, after the faces
};

/// Takes values off the front.
class ThreeDsCursor {
 public:
    explicit ThreeDsCursor(Bytes bytes) : bytes_(bytes) {}

    bool has(std::size_t size) const { return bytes_.size() >= size; }
    Bytes rest() const { return bytes_; }

    Bytes takeBytes(std::size_t size) {
        if (!has(size)) throw RenderError("a part of it ends too early");
        const Bytes front = bytes_.first(size);
        bytes_ = bytes_.subspan(size);
        return front;
    }

    template <typename Value>
    Value take() {
        Value value;
        std::memcpy(&value, takeBytes(sizeof value).data(), sizeof value);
        return value;
    }

    /// Up to a zero.
    std::string takeText() {
        const auto end = std::ranges::find(bytes_, std::uint8_t{0});
        const Bytes text = takeBytes(static_cast<std::size_t>(end - bytes_.begin()));
        takeBytes(1);
        return {text.begin(), text.end()};
    }

 private:
    Bytes bytes_;
};

float linearFromSrgb(float value) {
    return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

class ThreeDsReader {
 public:
    std::vector<MeshSurface> read(Bytes bytes) {
        ThreeDsCursor file(bytes);
        if (!file.has(6) || file.take<std::uint16_t>() != kFile) throw RenderError("it is no 3DS file");
        file.takeBytes(4);
        forEachChunk(file.rest(), [this](std::uint16_t id, Bytes content) {
            if (id == kEditor) readEditor(content);
        });
        paintSurfaces();
        return std::move(surfaces_);
    }

 private:
    /// Lengths that lie, and what is cut off, end the list.
    template <typename Visit>
    void forEachChunk(Bytes bytes, const Visit& visit) {
        constexpr std::size_t kHeader = 6;
        for (ThreeDsCursor list(bytes); list.has(kHeader);) {
            if (++chunks_ > kMostChunks) throw RenderError("it has too many parts; simplify it");
            const auto id = list.take<std::uint16_t>();
            const std::size_t size = list.take<std::uint32_t>();
            if (size < kHeader) return;
            visit(id, list.takeBytes(std::min(size - kHeader, list.rest().size())));
        }
    }

    void readEditor(Bytes bytes) {
        forEachChunk(bytes, [this](std::uint16_t id, Bytes content) {
            if (id == kMaterial) readMaterial(content);
            if (id == kObject) readObject(content);
        });
    }

    void readMaterial(Bytes bytes) {
        std::string name;
        std::optional<glm::vec3> diffuse;
        forEachChunk(bytes, [&](std::uint16_t id, Bytes content) {
            if (id == kMaterialName) name = ThreeDsCursor(content).takeText();
            if (id == kDiffuse) diffuse = readColor(content);
        });
        if (diffuse) paints_.try_emplace(std::move(name), *diffuse);
    }

    /// Bytes and floats are as screens show them; that the linear ones are not is said by their names alone.
    std::optional<glm::vec3> readColor(Bytes bytes) {
        std::optional<glm::vec3> color;
        forEachChunk(bytes, [&](std::uint16_t id, Bytes content) {
            const bool isFloat = id == kFloatColor || id == kLinearFloatColor;
            const bool isByte = id == kByteColor || id == kLinearByteColor;
            if (color || (!isFloat && !isByte)) return;
            ThreeDsCursor values(content);
            glm::vec3 read;
            for (int i = 0; i < 3; ++i) {
                const float value =
                    isFloat ? values.take<float>() : static_cast<float>(values.take<std::uint8_t>()) / 255.0f;
                // Not a number becomes 0, too.
                read[i] = linearFromSrgb(value > 0.0f ? std::min(value, 1.0f) : 0.0f);
            }
            color = read;
        });
        return color;
    }

    void readObject(Bytes bytes) {
        ThreeDsCursor object(bytes);
        object.takeText();
        forEachChunk(object.rest(), [this](std::uint16_t id, Bytes content) {
            if (id == kMesh) readMesh(content);
        });
    }

    void readMesh(Bytes bytes) {
        MeshSurface surface;
        Bytes faces;
        forEachChunk(bytes, [&](std::uint16_t id, Bytes content) {
            if (id == kVertices) readVertices(content, surface);
            if (id == kFaces) faces = content;
        });
        if (!faces.empty() && !surface.positionsM.empty()) readFaces(faces, std::move(surface));
    }

    void readVertices(Bytes bytes, MeshSurface& surface) {
        ThreeDsCursor vertices(bytes);
        const std::size_t count = vertices.take<std::uint16_t>();
        if (!vertices.has(count * 3 * sizeof(float))) throw RenderError("it has fewer vertices than it says");
        budget_.spend(count, 0);
        surface.positionsM.resize(count);
        for (glm::vec3& positionM : surface.positionsM) {
            for (int axis = 0; axis < 3; ++axis) positionM[axis] = kMetresPerUnit * vertices.take<float>();
        }
    }

    void readFaces(Bytes bytes, MeshSurface surface) {
        ThreeDsCursor faces(bytes);
        const std::size_t count = faces.take<std::uint16_t>();
        budget_.spend(0, count);
        std::vector<std::string> materials(1);  // The first is none.
        std::vector<std::size_t> materialOf(count, 0);
        for (std::size_t i = 0; i < count; ++i) {
            std::array<std::uint32_t, 3> triangle{};
            for (std::uint32_t& corner : triangle) {
                corner = faces.take<std::uint16_t>();
                if (corner >= surface.positionsM.size())
                    throw RenderError("a triangle has a corner that is not there");
            }
            faces.takeBytes(2);  // Which edges are drawn.
            surface.triangles.push_back(triangle);
        }
        forEachChunk(faces.rest(), [&](std::uint16_t id, Bytes content) {
            if (id == kFaceMaterial) readFaceMaterial(content, materials, materialOf);
        });
        splitByMaterial(surface, materials, materialOf);
    }

    static void readFaceMaterial(Bytes bytes, std::vector<std::string>& materials,
                                 std::vector<std::size_t>& materialOf) {
        ThreeDsCursor list(bytes);
        materials.push_back(list.takeText());
        for (std::size_t count = list.take<std::uint16_t>(); count > 0 && list.has(2); --count) {
            const std::size_t face = list.take<std::uint16_t>();
            if (face < materialOf.size()) materialOf[face] = materials.size() - 1;
        }
    }

    /// Only the vertices of a material's own triangles go with it.
    void splitByMaterial(const MeshSurface& whole, const std::vector<std::string>& materials,
                         const std::vector<std::size_t>& materialOf) {
        constexpr std::uint32_t kNone = 0xFFFFFFFF;
        std::vector<std::vector<std::size_t>> facesOf(materials.size());
        for (std::size_t i = 0; i < materialOf.size(); ++i) facesOf[materialOf[i]].push_back(i);
        std::vector<std::uint32_t> newIndex(whole.positionsM.size(), kNone);
        for (std::size_t material = 0; material < materials.size(); ++material) {
            if (facesOf[material].empty()) continue;
            MeshSurface& part = surfaces_.emplace_back();
            materialNames_.push_back(materials[material]);
            std::vector<std::uint32_t> used;
            for (const std::size_t face : facesOf[material]) {
                std::array<std::uint32_t, 3> triangle = whole.triangles[face];
                for (std::uint32_t& corner : triangle) {
                    if (newIndex[corner] == kNone) {
                        newIndex[corner] = static_cast<std::uint32_t>(part.positionsM.size());
                        part.positionsM.push_back(whole.positionsM[corner]);
                        used.push_back(corner);
                    }
                    corner = newIndex[corner];
                }
                part.triangles.push_back(triangle);
            }
            for (const std::uint32_t corner : used) newIndex[corner] = kNone;
        }
    }

    // Materials may come after the objects that have them.
    void paintSurfaces() {
        for (std::size_t i = 0; i < surfaces_.size(); ++i) {
            const auto found = paints_.find(materialNames_[i]);
            if (found != paints_.end()) surfaces_[i].paint = found->second;
        }
    }

    std::vector<MeshSurface> surfaces_;
    std::vector<std::string> materialNames_;  // One a surface.
    std::map<std::string, glm::vec3> paints_;
    MeshBudget budget_;
    std::size_t chunks_ = 0;
};

}  // namespace

std::vector<MeshSurface> read3ds(std::span<const std::uint8_t> bytes) {
    return ThreeDsReader().read(bytes);
}

}  // namespace hazer::render
