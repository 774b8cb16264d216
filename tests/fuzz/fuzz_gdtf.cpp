// A .gdtf archive or a description.xml may hold anything: it becomes a fixture type that can be patched and
// driven, or a ParseError and nothing else.
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "fixtures/gdtf.h"
#include "tests/fuzz/fixture_target.h"

namespace {

using namespace hazer::fixtures;

FixtureTypePtr parse(std::span<const std::uint8_t> data) {
    constexpr std::string_view kZipSignature = "PK";
    const std::string_view text(reinterpret_cast<const char*>(data.data()), data.size());
    if (text.starts_with(kZipSignature)) return parseGdtfArchive({data.begin(), data.end()}, "fuzz.gdtf");
    return std::make_shared<FixtureType>(parseGdtfDescription(text, "fuzz.xml", nullptr));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span input(data, size);
    try {
        const FixtureTypePtr type = parse(input);
        for (const DmxMode& mode : type->modes) {
            Fixture fixture("fuzz", type, mode.name, 1, glm::dmat4(1.0));
            drive(fixture, input);
        }
    } catch (const ParseError&) {
        // The answer to a broken file.
    }
    return 0;
}
