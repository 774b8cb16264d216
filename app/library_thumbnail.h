// Small pictures of the library's fixtures, each with its light on.
#pragma once

#include <filesystem>

#include "app/library_listing.h"

namespace hazer::app {

/// Draws the fixture in the air of a dark room, lit, with a gobo in its beam if it has one, and writes the
/// picture. `number` chooses the colour. Needs a current OpenGL 4.1 context. Throws as Session and
/// writePicture().
void drawThumbnail(const LibraryEntry& entry, int number, int width, int height,
                   const std::filesystem::path& file);

}  // namespace hazer::app
