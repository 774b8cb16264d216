// Runs a fuzz target over seeds, for builds without libFuzzer: replay SEED_FILE_OR_FOLDER...
// Each seed is run whole, then cut short at many places.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;

// A packet is cut at every byte, a longer file at about this many places.
constexpr std::size_t kMaxCuts = 600;

std::vector<fs::path> seedsIn(const fs::path& fileOrFolder) {
    if (!fs::is_directory(fileOrFolder)) return {fileOrFolder};
    std::vector<fs::path> seeds;
    for (const auto& entry : fs::recursive_directory_iterator(fileOrFolder)) {
        if (entry.is_regular_file()) seeds.push_back(entry.path());
    }
    std::sort(seeds.begin(), seeds.end());
    return seeds;
}

std::vector<char> bytesOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

// In a heap block of exactly its size, where a sanitizer sees any read beyond.
void runPrefix(const std::vector<char>& bytes, std::size_t size) {
    const std::vector<std::uint8_t> prefix(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    LLVMFuzzerTestOneInput(prefix.data(), prefix.size());
}

void runWholeAndCut(const std::vector<char>& bytes) {
    runPrefix(bytes, bytes.size());
    const std::size_t step = bytes.size() / kMaxCuts + 1;
    for (std::size_t size = 0; size < bytes.size(); size += step) runPrefix(bytes, size);
}

}  // namespace

int main(int argumentCount, char** arguments) {
    int seedCount = 0;
    for (int i = 1; i < argumentCount; ++i) {
        for (const fs::path& seed : seedsIn(arguments[i])) {
            runWholeAndCut(bytesOf(seed));
            ++seedCount;
        }
    }
    std::printf("%d seeds\n", seedCount);
    return seedCount > 0 ? 0 : 1;
}
