// Where fixtures come from: the library that comes with hazer, or a file beside the show.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace hazer::app {

/// Names of the fixtures that come with hazer, sorted.
std::vector<std::string> libraryFixtures();

/// The folder of a fixture that comes with hazer. Empty if there is none of that name.
std::optional<std::filesystem::path> findLibraryFixture(const std::string& name);

/// Where the GDTF of that name is: a plain name is a fixture of the library, anything else a path relative to
/// `folder`. Throws std::runtime_error, which lists the library, if there is neither.
std::filesystem::path resolveGdtf(const std::string& nameOrPath, const std::filesystem::path& folder);

}  // namespace hazer::app
