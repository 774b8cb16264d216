// Keys and mouse, on one sheet.
#pragma once

namespace hazer::app {

/// `isOpen` becomes false when the person closes it.
void drawHelpPanel(bool& isOpen);

}  // namespace hazer::app
