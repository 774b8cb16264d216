// A show file may hold anything: it becomes a show, or a ShowError and nothing else.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "app/show.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace hazer::app;
    try {
        parseShow({reinterpret_cast<const char*>(data), size}, "fuzz.toml");
    } catch (const ShowError&) {
        // The answer to a broken file.
    }
    return 0;
}
