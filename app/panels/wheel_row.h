// Wheels as rows of pictures: gobos as they look, colours as they are.
#pragma once

#include <map>
#include <string>

#include "app/window_faders.h"
#include "app/window_held_faders.h"
#include "app/window_thumbnails.h"

namespace hazer::app {

/// A button for each slot of the fader's wheel, which must not be null; the slot that is in the light is
/// framed.
void drawColorWheelRow(const Fader& fader, fixtures::Fixture& fixture, HeldFaders& held,
                       WindowThumbnails& thumbnails);

/// The same, with a box that takes the gobo out of the light and puts it back. `lastGobos` remembers which
/// one it was, by fixture and attribute.
void drawGoboWheelRow(const Fader& fader, fixtures::Fixture& fixture, HeldFaders& held,
                      WindowThumbnails& thumbnails, std::map<std::string, int>& lastGobos);

}  // namespace hazer::app
