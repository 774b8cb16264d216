// Any bytes as a sequence of xLights.
#include "protocol/recording/fseq_reader.h"
#include "tests/fuzz/recording_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace hazer::protocol;
    return fuzz::run(data, size, [](const std::filesystem::path& path) { return openFseq(path, {}); });
}
