// A report's text as a file.
#pragma once

#include <filesystem>
#include <string_view>

namespace hazer::app {

/// Writes beside the target and renames, so that a full disk leaves an older file whole. Throws
/// std::runtime_error.
void writeText(const std::filesystem::path& file, std::string_view text);

}  // namespace hazer::app
