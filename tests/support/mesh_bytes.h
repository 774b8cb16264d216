// Writes the bytes of meshes, for tests.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>

namespace hazer::test {

/// The values one after the other, as this machine (little-endian, as both formats are) holds them.
template <typename Value>
std::string bytesOf(std::initializer_list<Value> values) {
    std::string bytes;
    for (const Value value : values) bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    return bytes;
}

/// A part of a 3DS file: its number, its length with these two, its content.
inline std::string chunk3ds(std::uint16_t id, const std::string& content) {
    return bytesOf<std::uint16_t>({id}) +
           bytesOf<std::uint32_t>({static_cast<std::uint32_t>(content.size()) + 6}) + content;
}

/// An object of one mesh: places of its vertices [mm], and for each triangle its corners and flags.
/// `afterFaces` are the chunks that say more of the triangles.
inline std::string object3ds(std::initializer_list<float> places, std::initializer_list<std::uint16_t> faces,
                             const std::string& afterFaces = "") {
    const auto count = [](std::size_t values) {
        return bytesOf<std::uint16_t>({static_cast<std::uint16_t>(values)});
    };
    const std::string vertices = chunk3ds(0x4110, count(places.size() / 3) + bytesOf(places));
    const std::string triangles = chunk3ds(0x4120, count(faces.size() / 4) + bytesOf(faces) + afterFaces);
    return chunk3ds(0x4000, std::string("object\0", 7) + chunk3ds(0x4100, vertices + triangles));
}

/// A file of these materials and objects.
inline std::string file3ds(const std::string& content) {
    return chunk3ds(0x4D4D, chunk3ds(0x3D3D, content));
}

/// A binary glTF of this JSON and this buffer.
inline std::string glbOf(std::string json, std::string buffer) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    buffer.resize((buffer.size() + 3) / 4 * 4, '\0');
    const auto part = [](const char* type, const std::string& content) {
        return bytesOf<std::uint32_t>({static_cast<std::uint32_t>(content.size())}) + std::string(type, 4) +
               content;
    };
    const std::string parts = part("JSON", json) + part("BIN\0", buffer);
    return "glTF" + bytesOf<std::uint32_t>({2, static_cast<std::uint32_t>(parts.size()) + 12}) + parts;
}

}  // namespace hazer::test
