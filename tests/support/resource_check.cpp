#include "tests/support/resource_check.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <map>

namespace hazer::test {
namespace {

using render::Resources;
using ::testing::ElementsAreArray;
using ::testing::UnorderedElementsAreArray;

/// As text, so that a failure can be read.
std::vector<std::string> describe(const std::vector<render::TextureUse>& textures) {
    std::vector<std::string> lines;
    for (const render::TextureUse& use : textures) {
        lines.push_back(fmt::format("{}: {}x{}x{}, {} levels, {} bytes", use.name, use.width, use.height,
                                    use.layers, use.levels, use.bytes));
    }
    return lines;
}

std::map<std::string, std::size_t> bytesByName(const std::vector<render::BufferUse>& buffers) {
    std::map<std::string, std::size_t> bytes;
    for (const render::BufferUse& buffer : buffers) bytes[buffer.name] += buffer.bytes;
    return bytes;
}

}  // namespace

std::vector<std::string> passNames(const render::Renderer& renderer) {
    std::vector<std::string> names;
    for (const render::PassTime& pass : renderer.lastPassTimes()) names.push_back(pass.name);
    return names;
}

void expectAsPlanned(const render::PlanSummary& summary, const render::Renderer& renderer) {
    const Resources planned = render::neededResources(summary);
    const Resources real = renderer.resources();
    EXPECT_THAT(passNames(renderer), ElementsAreArray(summary.passes));
    EXPECT_THAT(describe(real.textures), UnorderedElementsAreArray(describe(planned.textures)));
    EXPECT_THAT(real.shaders, UnorderedElementsAreArray(planned.shaders));
    const std::map<std::string, std::size_t> plannedBytes = bytesByName(planned.buffers);
    for (const auto& [name, bytes] : bytesByName(real.buffers)) {
        const auto found = plannedBytes.find(name);
        ASSERT_NE(found, plannedBytes.end()) << name;
        EXPECT_LE(bytes, found->second) << name;
    }
}

}  // namespace hazer::test
