// A .qxf file may hold anything: it becomes a fixture type that can be patched and driven, or a ParseError.
#include "fixtures/qxf.h"
#include "tests/fuzz/fixture_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    hazer::fixtures::parseAndDrive(std::span(data, size), [](std::string_view text) {
        return hazer::fixtures::parseQxf(text, "fuzz.qxf");
    });
    return 0;
}
