#include "app/program_search.h"

#include <unistd.h>

#include <cstdlib>
#include <sstream>

namespace hazer::app {

std::optional<std::filesystem::path> findProgram(const std::string& name) {
    const char* folders = std::getenv("PATH");
    std::istringstream list(folders == nullptr ? "" : folders);
    for (std::string folder; std::getline(list, folder, ':');) {
        const std::filesystem::path candidate = std::filesystem::path(folder) / name;
        std::error_code ignored;
        const bool isFile = std::filesystem::is_regular_file(candidate, ignored);
        if (isFile && access(candidate.c_str(), X_OK) == 0) return candidate;
    }
    return std::nullopt;
}

}  // namespace hazer::app
