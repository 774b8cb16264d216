#include "render/mesh_glb.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>
#include <string>

namespace hazer::render {
namespace {

using Bytes = std::span<const std::uint8_t>;
using Json = nlohmann::json;

constexpr std::size_t kMaxJsonBytes = std::size_t{2} << 20;
constexpr int kMaxJsonDepth = 64;
constexpr int kMaxNodeDepth = 64;
constexpr std::size_t kMaxNodes = 100'000;

constexpr std::int64_t kByteType = 5121;
constexpr std::int64_t kShortType = 5123;
constexpr std::int64_t kIntType = 5125;
constexpr std::int64_t kFloatType = 5126;

/// As a primitive's "mode".
enum class PrimitiveMode { kTriangles = 4, kStrip = 5, kFan = 6 };

[[noreturn]] void failGlb(const std::string& reason) {
    throw RenderError(reason);
}

std::uint32_t wordAt(Bytes bytes, std::size_t at) {
    if (bytes.size() < 4 || at > bytes.size() - 4) failGlb("it ends too early");
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + at, sizeof word);
    return word;
}

struct GlbParts {
    Bytes json;
    Bytes buffer;
};

GlbParts partsOf(Bytes bytes) {
    constexpr std::uint32_t kMagic = 0x46546C67;
    constexpr std::uint32_t kJson = 0x4E4F534A;
    constexpr std::uint32_t kBinary = 0x004E4942;
    constexpr std::size_t kHeader = 12;
    if (bytes.size() < kHeader || wordAt(bytes, 0) != kMagic || wordAt(bytes, 4) != 2)
        failGlb("it is no binary glTF 2.0");
    GlbParts parts;
    for (std::size_t at = kHeader; bytes.size() - at >= 8;) {
        const std::size_t size = wordAt(bytes, at);
        const std::uint32_t type = wordAt(bytes, at + 4);
        at += 8;
        if (size > bytes.size() - at) failGlb("it ends too early");
        if (type == kJson && parts.json.empty()) parts.json = bytes.subspan(at, size);
        if (type == kBinary && parts.buffer.empty()) parts.buffer = bytes.subspan(at, size);
        at += size;
    }
    return parts;
}

/// The deepest nesting of lists and objects.
int depthOf(Bytes json) {
    int depth = 0;
    int deepest = 0;
    bool isInText = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const std::uint8_t letter = json[i];
        if (letter == '"') isInText = !isInText;
        if (isInText) {
            if (letter == '\\') ++i;
        } else if (letter == '[' || letter == '{') {
            deepest = std::max(deepest, ++depth);
        } else if (letter == ']' || letter == '}') {
            --depth;
        }
    }
    return deepest;
}

Json parseJson(Bytes text) {
    if (text.size() > kMaxJsonBytes)
        failGlb(fmt::format("its JSON is larger than {} MiB; simplify it", kMaxJsonBytes >> 20));
    if (depthOf(text) > kMaxJsonDepth) failGlb("its JSON is nested too deep");
    try {
        return Json::parse(text.begin(), text.end());
    } catch (const Json::exception&) {
        failGlb("its JSON is broken");
    }
}

/// The element of that name; null where it is none or absent.
const Json& member(const Json& object, const char* name) {
    static const Json kNull;
    if (!object.is_object()) return kNull;
    const auto found = object.find(name);
    return found == object.end() ? kNull : *found;
}

/// A count or offset.
std::size_t sizeIn(const Json& object, const char* name, std::size_t otherwise) {
    const Json& value = member(object, name);
    if (value.is_null()) return otherwise;
    constexpr std::uint64_t kLargest = std::uint64_t{1} << 40;
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() > kLargest)
        failGlb(fmt::format("its {} is no count", name));
    return static_cast<std::size_t>(value.get<std::uint64_t>());
}

/// What the index `number` names in a list of the file's root.
const Json& listed(const Json& root, const char* list, const Json& number) {
    const Json& elements = member(root, list);
    if (!elements.is_array() || !number.is_number_unsigned() ||
        number.get<std::uint64_t>() >= elements.size()) {
        failGlb(fmt::format("it refers to {} that are not there", list));
    }
    return elements[static_cast<std::size_t>(number.get<std::uint64_t>())];
}

template <std::size_t count>
bool readNumbers(const Json& list, std::array<double, count>& numbers) {
    if (list.is_null()) return false;
    if (!list.is_array() || list.size() != count)
        failGlb("a list of numbers has another length than it must");
    for (std::size_t i = 0; i < count; ++i) {
        if (!list[i].is_number()) failGlb("a list of numbers holds something else");
        numbers[i] = list[i].get<double>();
    }
    return true;
}

glm::dmat4 parentFromNode(const Json& node) {
    std::array<double, 16> matrix{};
    if (readNumbers(member(node, "matrix"), matrix)) {
        glm::dmat4 result;
        for (int i = 0; i < 16; ++i) result[i / 4][i % 4] = matrix[static_cast<std::size_t>(i)];
        return result;
    }
    std::array<double, 3> translation{0.0, 0.0, 0.0};
    std::array<double, 4> rotation{0.0, 0.0, 0.0, 1.0};  // x, y, z, w
    std::array<double, 3> scale{1.0, 1.0, 1.0};
    readNumbers(member(node, "translation"), translation);
    readNumbers(member(node, "rotation"), rotation);
    readNumbers(member(node, "scale"), scale);
    const glm::dquat turn(rotation[3], rotation[0], rotation[1], rotation[2]);
    const glm::dmat4 moved =
        glm::translate(glm::dmat4(1.0), {translation[0], translation[1], translation[2]});
    return glm::scale(moved * glm::mat4_cast(turn), {scale[0], scale[1], scale[2]});
}

/// The values of an accessor where they lie in the buffer.
struct GlbAccessor {
    Bytes bytes;  // From its first value on.
    std::size_t stride = 0;
    std::size_t count = 0;
    std::int64_t type = 0;

    template <typename Value>
    Value at(std::size_t index, std::size_t component = 0) const {
        Value value;
        std::memcpy(&value, bytes.data() + index * stride + component * sizeof value, sizeof value);
        return value;
    }
};

class GlbReader {
 public:
    explicit GlbReader(const GlbParts& parts) : root_(parseJson(parts.json)), buffer_(parts.buffer) {}

    std::vector<MeshSurface> read() {
        const Json& required = member(root_, "extensionsRequired");
        if (required.is_array() && !required.empty())
            failGlb("it requires extensions; export it without compression");
        const Json& number = member(root_, "scene");
        const Json& scene = listed(root_, "scenes", number.is_null() ? Json(0u) : number);
        // (x, y, z) of glTF is (x, -z, y) here.
        const glm::dmat4 zUpFromYUp(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1);
        readNodes(member(scene, "nodes"), zUpFromYUp, 0);
        return std::move(surfaces_);
    }

 private:
    void readNodes(const Json& numbers, const glm::dmat4& world, int depth) {
        if (depth > kMaxNodeDepth) failGlb("its nodes lie too deep in each other, or in themselves");
        if (!numbers.is_array()) return;
        for (const Json& number : numbers) {
            if (++nodes_ > kMaxNodes) failGlb("it has too many nodes; simplify it");
            const Json& node = listed(root_, "nodes", number);
            const glm::dmat4 worldFromNode = world * parentFromNode(node);
            const Json& mesh = member(node, "mesh");
            if (!mesh.is_null()) readMesh(listed(root_, "meshes", mesh), worldFromNode);
            readNodes(member(node, "children"), worldFromNode, depth + 1);
        }
    }

    void readMesh(const Json& mesh, const glm::dmat4& worldFromMesh) {
        const Json& primitives = member(mesh, "primitives");
        if (!primitives.is_array()) return;
        for (const Json& primitive : primitives) {
            // A mesh without triangles costs time, too.
            if (++nodes_ > kMaxNodes) failGlb("it has too many primitives; simplify it");
            const std::size_t mode = sizeIn(primitive, "mode", 4);
            if (mode >= 4 && mode <= 6)
                readPrimitive(primitive, static_cast<PrimitiveMode>(mode), worldFromMesh);
        }
    }

    void readPrimitive(const Json& primitive, PrimitiveMode mode, const glm::dmat4& worldFromMesh) {
        const Json& attributes = member(primitive, "attributes");
        if (member(attributes, "POSITION").is_null()) return;
        const GlbAccessor places = accessor(member(attributes, "POSITION"), "VEC3");
        const Json& indices = member(primitive, "indices");
        const GlbAccessor order =
            indices.is_null() ? GlbAccessor{{}, 0, places.count, 0} : accessor(indices, "SCALAR");
        budget_.spend(places.count, mode == PrimitiveMode::kTriangles ? order.count / 3 : order.count);

        MeshSurface& surface = surfaces_.emplace_back();
        for (std::size_t i = 0; i < places.count; ++i)
            surface.positionsM.emplace_back(worldFromMesh * glm::dvec4(vectorAt(places, i), 1.0));
        const bool isMirrored = glm::determinant(glm::dmat3(worldFromMesh)) < 0.0;
        appendTriangles(order, mode, isMirrored, surface);
        if (const Json& normals = member(attributes, "NORMAL"); !normals.is_null())
            readNormals(accessor(normals, "VEC3"), worldFromMesh, surface);
        surface.paint = paintOf(member(primitive, "material"));
    }

    static glm::dvec3 vectorAt(const GlbAccessor& accessor, std::size_t index) {
        if (accessor.type != kFloatType) failGlb("its vertices are not of floating point numbers");
        return {accessor.at<float>(index, 0), accessor.at<float>(index, 1), accessor.at<float>(index, 2)};
    }

    static void readNormals(const GlbAccessor& normals, const glm::dmat4& worldFromMesh,
                            MeshSurface& surface) {
        if (normals.count != surface.positionsM.size()) return;
        // The cofactors, which exist also where the inverse does not.
        const glm::dmat3 m(worldFromMesh);
        glm::dmat3 turn(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
        if (glm::determinant(m) < 0.0) turn = -turn;
        for (std::size_t i = 0; i < normals.count; ++i) {
            const glm::dvec3 normal = turn * vectorAt(normals, i);
            const double length = glm::length(normal);
            surface.normals.emplace_back(length > 0.0 ? normal / length : glm::dvec3(0.0));
        }
    }

    static std::uint32_t indexAt(const GlbAccessor& order, std::size_t i) {
        switch (order.type) {
            case 0:  // Without indices: one vertex after the other.
                return static_cast<std::uint32_t>(i);
            case kByteType:
                return order.at<std::uint8_t>(i);
            case kShortType:
                return order.at<std::uint16_t>(i);
            case kIntType:
                return order.at<std::uint32_t>(i);
            default:
                failGlb("its indices are no whole numbers");
        }
    }

    static void appendTriangles(const GlbAccessor& order, PrimitiveMode mode, bool isMirrored,
                                MeshSurface& surface) {
        const std::size_t step = mode == PrimitiveMode::kTriangles ? 3 : 1;
        for (std::size_t i = 0; i + 2 < order.count; i += step) {
            // Every second triangle of a strip is wound the other way.
            const bool isTurned = isMirrored != (mode == PrimitiveMode::kStrip && i % 2 == 1);
            std::array<std::uint32_t, 3> triangle{indexAt(order, mode == PrimitiveMode::kFan ? 0 : i),
                                                  indexAt(order, i + 1), indexAt(order, i + 2)};
            if (isTurned) std::swap(triangle[1], triangle[2]);
            for (const std::uint32_t corner : triangle) {
                if (corner >= surface.positionsM.size()) failGlb("a triangle has a corner that is not there");
            }
            surface.triangles.push_back(triangle);
        }
    }

    GlbAccessor accessor(const Json& number, const char* shape) const {
        const Json& json = listed(root_, "accessors", number);
        if (!member(json, "sparse").is_null()) failGlb("it has sparse accessors; export it without");
        if (member(json, "type") != shape) failGlb("an accessor has another shape than it must");
        const Json& view = listed(root_, "bufferViews", member(json, "bufferView"));
        const Json& buffer = listed(root_, "buffers", member(view, "buffer"));
        if (sizeIn(view, "buffer", 0) != 0 || !member(buffer, "uri").is_null())
            failGlb("its vertices lie in another file");

        GlbAccessor result;
        result.type = static_cast<std::int64_t>(sizeIn(json, "componentType", 0));
        result.count = sizeIn(json, "count", 0);
        const std::size_t size = componentBytes(result.type) * (std::string_view(shape) == "VEC3" ? 3 : 1);
        result.stride = sizeIn(view, "byteStride", size);
        const std::size_t viewStart = sizeIn(view, "byteOffset", 0);
        const std::size_t viewSize = sizeIn(view, "byteLength", 0);
        const std::size_t start = sizeIn(json, "byteOffset", 0);
        requireCountable(result);
        const std::size_t needed = result.count == 0 ? 0 : (result.count - 1) * result.stride + size;
        const bool isInBuffer = viewStart <= buffer_.size() && viewSize <= buffer_.size() - viewStart;
        if (!isInBuffer || start > viewSize || needed > viewSize - start)
            failGlb("an accessor reaches past the end of the buffer");
        result.bytes = buffer_.subspan(viewStart + start);
        return result;
    }

    /// Larger numbers could not be multiplied.
    static void requireCountable(const GlbAccessor& accessor) {
        constexpr std::size_t kMostValues = 4 * kMaxRigTriangles;
        constexpr std::size_t kWidestStride = 1024;
        if (accessor.count > kMostValues || accessor.stride > kWidestStride)
            failGlb("an accessor is too large; simplify it");
    }

    static std::size_t componentBytes(std::int64_t type) {
        switch (type) {
            case kByteType:
                return 1;
            case kShortType:
                return 2;
            case kIntType:
            case kFloatType:
                return 4;
            default:
                failGlb("an accessor has an unknown componentType");
        }
    }

    std::optional<glm::vec3> paintOf(const Json& number) const {
        if (number.is_null()) return std::nullopt;
        const Json& material = listed(root_, "materials", number);
        std::array<double, 4> factor{};
        if (!readNumbers(member(member(material, "pbrMetallicRoughness"), "baseColorFactor"), factor))
            return std::nullopt;
        return glm::clamp(glm::vec3(factor[0], factor[1], factor[2]), 0.0f, 1.0f);
    }

    Json root_;
    Bytes buffer_;
    std::vector<MeshSurface> surfaces_;
    MeshBudget budget_;
    std::size_t nodes_ = 0;
};

}  // namespace

std::vector<MeshSurface> readGlb(std::span<const std::uint8_t> bytes) {
    return GlbReader(partsOf(bytes)).read();
}

}  // namespace hazer::render
