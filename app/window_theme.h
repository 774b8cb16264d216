// How the panels look.
#pragma once

namespace hazer::app {

/// Sets ImGui's colours, sizes and font for a screen on which text is `contentScale` times larger than on a
/// plain one. The backend must make its font texture anew afterwards.
void applyTheme(float contentScale);

}  // namespace hazer::app
