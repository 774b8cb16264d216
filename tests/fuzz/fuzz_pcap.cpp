// Any bytes as a capture of a network.
#include "protocol/recording/pcap_reader.h"
#include "tests/fuzz/recording_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace hazer::protocol;
    return fuzz::run(data, size, [](const std::filesystem::path& path) { return openPcap(path); });
}
