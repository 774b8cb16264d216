// Other programs that hazer uses when they are there.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace hazer::app {

/// The executable file of that name in the folders of PATH. Empty if there is none.
std::optional<std::filesystem::path> findProgram(const std::string& name);

}  // namespace hazer::app
