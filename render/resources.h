// What is held on the GPU for a picture: what a renderer has, or what a plan says it will have.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace hazer::render {

/// One texture. `layers` counts those of an array, or the slices of a volume at its first level.
struct TextureUse {
    std::string name;
    int width = 0;
    int height = 0;
    int layers = 1;
    int levels = 1;  ///< Mip levels.
    std::size_t bytes =
        0;  ///< Of all levels, by the sizes of the format's components; a driver may pad them.
    bool operator==(const TextureUse&) const = default;
};

struct BufferUse {
    std::string name;
    std::size_t bytes = 0;
    bool operator==(const BufferUse&) const = default;
};

struct Resources {
    std::vector<TextureUse> textures;
    std::vector<BufferUse> buffers;
    std::vector<std::string> shaders;  ///< Compiled programs: fragment shader, then its features.
};

/// Bytes of all textures, and of all buffers.
std::size_t textureBytes(const Resources& resources);
std::size_t bufferBytes(const Resources& resources);

/// How a program is named in Resources: "air.frag", "air.frag GOBO SHADOW".
std::string shaderName(const std::string& fragmentFile, const std::vector<std::string>& features = {});

}  // namespace hazer::render
