// What the fixtures of hazer's library are and can, for people, for machines and as a page of the
// documentation.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "fixtures/fixture_type.h"

namespace hazer::app {

struct LibraryEntry {
    std::string folder;  ///< By which shows name it.
    fixtures::FixtureTypePtr type;
};

/// Fixtures of the library by their folders; all of them where none is named. Throws fixtures::ParseError, or
/// std::runtime_error where there is none of a name.
std::vector<LibraryEntry> readLibrary(const std::vector<std::string>& folders);

/// What a fixture's first mode has channels for, in words of the trade: "pan and tilt", "2 gobo wheels" ...
std::vector<std::string> abilitiesOf(const fixtures::FixtureType& type);

/// [{"folder", "name", "manufacturer", "modes": [{"name", "slots", "beams", "flux_lm"}], "can": [abilities]}]
nlohmann::ordered_json describeLibrary(const std::vector<LibraryEntry>& library);

/// A line a fixture.
std::string summarizeLibrary(const std::vector<LibraryEntry>& library);

/// A page in Markdown, with the pictures that lie as FOLDER.png in `pictureFolder`, relative to the page.
std::string libraryPage(const std::vector<LibraryEntry>& library, const std::string& pictureFolder);

}  // namespace hazer::app
