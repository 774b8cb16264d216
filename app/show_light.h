// [[light]]: a bare light of a show, given by numbers.
#pragma once

#include <filesystem>

#include "app/show.h"
#include "app/toml_reader.h"

namespace hazer::app {

/// Reads one [[light]]; files are relative to `folder` and are not opened. Throws ShowError.
ShowLight readLight(TomlReader& reader, const std::filesystem::path& folder);

}  // namespace hazer::app
