// A rig (MVR) in a show: its fixtures and scene objects, or the whole of a show made from it.
#pragma once

#include <filesystem>

#include "app/show.h"

namespace hazer::app {

/// Whether a file is an MVR by its name.
bool isRig(const std::filesystem::path& file);

/// Adds the fixtures and scene objects of show.rig to those of the show. Fixtures get names that are unique;
/// one whose GDTF is missing, broken or without light is replaced by one of hazer's library, with a sentence
/// in show.warnings. Throws ShowError if the MVR cannot be read at all.
void addRig(Show& show);

/// The rig alone, on a floor in a little light, with cameras that see all of it.
Show showOfRig(const std::filesystem::path& file);

}  // namespace hazer::app
