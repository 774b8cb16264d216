// What mouse and keys do outside the panels.
#pragma once

#include <vector>

#include "app/session.h"
#include "app/window.h"
#include "app/window_state.h"

namespace hazer::app {

/// Orbits, pans, dollies and selects with the mouse, unless a panel has it. Call between WindowGui::begin and
/// draw.
void followMouse(Session& session, WindowState& state);

/// Does what the pressed keys ask for, unless text is being typed.
void followKeys(const std::vector<Key>& keys, const Show& show, WindowState& state);

/// Marks the selected fixture in the picture.
void markSelected(Session& session, const WindowState& state);

}  // namespace hazer::app
