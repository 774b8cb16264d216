// A description.xml may hold anything: it becomes a fixture type, or a ParseError and nothing else.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fixtures/gdtf.h"
#include "fixtures/parse_error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace hazer::fixtures;
    const auto noImages = [](const std::string&) { return std::shared_ptr<const WheelImage>(); };
    try {
        parseGdtfDescription({reinterpret_cast<const char*>(data), size}, "fuzz.xml", noImages);
    } catch (const ParseError&) {
        // The answer to a broken file.
    }
    return 0;
}
