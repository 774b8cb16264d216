#include "render/resources.h"

#include <numeric>

namespace hazer::render {
namespace {

template <typename Use>
std::size_t sumOfBytes(const std::vector<Use>& uses) {
    return std::accumulate(uses.begin(), uses.end(), std::size_t{0},
                           [](std::size_t sum, const Use& use) { return sum + use.bytes; });
}

}  // namespace

std::size_t textureBytes(const Resources& resources) {
    return sumOfBytes(resources.textures);
}

std::size_t bufferBytes(const Resources& resources) {
    return sumOfBytes(resources.buffers);
}

std::string shaderName(const std::string& fragmentFile, const std::vector<std::string>& features) {
    std::string name = fragmentFile;
    for (const std::string& feature : features) name += " " + feature;
    return name;
}

}  // namespace hazer::render
