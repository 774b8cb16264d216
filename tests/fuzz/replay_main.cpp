// Runs a fuzz target once over every file of a folder, for builds without libFuzzer: replay FOLDER
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

// In a heap block of exactly its size, where a sanitizer sees any read beyond.
std::vector<std::uint8_t> bytesOf(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    const std::vector<char> chars{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    return {chars.begin(), chars.end()};
}

}  // namespace

int main(int argumentCount, char** arguments) {
    if (argumentCount != 2) {
        std::fprintf(stderr, "usage: %s FOLDER\n", arguments[0]);
        return 1;
    }
    int fileCount = 0;
    for (const auto& entry : std::filesystem::directory_iterator(arguments[1])) {
        const std::vector<std::uint8_t> bytes = bytesOf(entry.path());
        LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
        ++fileCount;
    }
    std::printf("%d files\n", fileCount);
    return fileCount > 0 ? 0 : 1;
}
