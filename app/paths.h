// Where hazer's own files are: shaders, the fixture library, the shipped shows.
#pragma once

#include <filesystem>

namespace hazer::app {

/// The folder that holds shaders/, fixtures/library/ and app/shows/: $HAZER_DATA if set, else share/hazer
/// beside the installed program, else the source tree this program was built from. Throws std::runtime_error
/// with what to do if there is none.
std::filesystem::path dataFolder();

std::filesystem::path shaderFolder();
std::filesystem::path libraryFolder();
std::filesystem::path showFolder();

}  // namespace hazer::app
