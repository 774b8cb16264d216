// One fader of a fixture as a row of a table: its name, its control, and a way back to DMX.
#pragma once

#include <functional>

#include "app/window_faders.h"
#include "app/window_held_faders.h"

namespace hazer::app {

/// Colour of everything that a hand holds (ImGui's packed form).
inline constexpr unsigned kHeldColor = 0xFF50BEFFu;

/// Lays rows out one under the other. `draw` makes them.
void drawFaderTable(const char* id, const std::function<void()>& draw);

/// A row with a list of the fader's names.
void drawNameRow(const Fader& fader, fixtures::Fixture& fixture, HeldFaders& held);

/// A row with a slider; behind its value stands what the fixture's file calls that.
void drawSliderRow(const Fader& fader, fixtures::Fixture& fixture, HeldFaders& held);

/// A row whose control `draw` makes, with all the width it may take.
void drawRow(const Fader& fader, fixtures::Fixture& fixture, HeldFaders& held,
             const std::function<void()>& draw);

}  // namespace hazer::app
