// Any bytes as a sequence of xLights.
#include "protocol/recording/fseq_reader.h"
#include "tests/fuzz/recording_target.h"

namespace {

// Sixteen million channels are allowed, and clearing the room for them takes longer than a thousand runs with
// few. fseq_reader_test.cpp has the largest number.
bool claimsManyChannels(const std::uint8_t* data, std::size_t size) {
    constexpr std::size_t kChannelCountAt = 10;  // four bytes, low byte first
    return size >= kChannelCountAt + 4 && (data[kChannelCountAt + 2] != 0 || data[kChannelCountAt + 3] != 0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace hazer::protocol;
    if (claimsManyChannels(data, size)) return 0;
    return fuzz::run(data, size, [](const std::filesystem::path& path) { return openFseq(path, {}); });
}
