#include "app/paths.h"

#include <array>
#include <cstdlib>
#include <stdexcept>

namespace hazer::app {

std::filesystem::path dataFolder() {
    namespace fs = std::filesystem;
    if (const char* chosen = std::getenv("HAZER_DATA"); chosen != nullptr && *chosen != '\0') return chosen;
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    for (const fs::path& folder :
         std::array<fs::path, 2>{program.parent_path() / ".." / "share" / "hazer", HAZER_SOURCE_FOLDER}) {
        if (fs::is_directory(folder / "shaders", ignored)) return fs::weakly_canonical(folder);
    }
    throw std::runtime_error(
        "hazer's own files (shaders, fixtures) were not found; set HAZER_DATA to the folder that holds them");
}

std::filesystem::path shaderFolder() {
    return dataFolder() / "shaders";
}
std::filesystem::path libraryFolder() {
    return dataFolder() / "fixtures" / "library";
}
std::filesystem::path showFolder() {
    return dataFolder() / "app" / "shows";
}

}  // namespace hazer::app
