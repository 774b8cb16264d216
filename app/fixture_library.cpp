#include "app/fixture_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "app/nearest_name.h"
#include "app/paths.h"

namespace hazer::app {
namespace {

bool isUnpackedGdtf(const std::filesystem::path& folder) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(folder / "description.xml", ignored);
}

/// A name has no folder in it, so that it cannot lead out of the library.
bool isPlainName(const std::string& name) {
    return !name.empty() && name.find_first_of("/\\.") == std::string::npos;
}

}  // namespace

std::vector<std::string> libraryFixtures() {
    std::vector<std::string> names;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(libraryFolder(), ignored)) {
        if (isUnpackedGdtf(entry.path())) names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::optional<std::filesystem::path> findLibraryFixture(const std::string& name) {
    if (!isPlainName(name)) return std::nullopt;
    const std::filesystem::path folder = libraryFolder() / name;
    return isUnpackedGdtf(folder) ? std::optional(folder) : std::nullopt;
}

std::filesystem::path resolveGdtf(const std::string& nameOrPath, const std::filesystem::path& folder) {
    if (const auto found = findLibraryFixture(nameOrPath)) return *found;
    const std::filesystem::path path = folder / nameOrPath;
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored)) return path;
    throw std::runtime_error(
        fmt::format("there is no GDTF '{}', neither as the file {} nor in hazer's library.{}", nameOrPath,
                    path.string(), suggestName(nameOrPath, libraryFixtures())));
}

}  // namespace hazer::app
