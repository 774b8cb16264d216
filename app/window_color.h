// Colours as a screen shows them: sRGB, 0..1 a component (IEC 61966-2-1).
#pragma once

#include <glm/glm.hpp>

#include "fixtures/fixture_type.h"
#include "render/scene.h"

namespace hazer::app {

/// From linear Rec. 2020. What a screen cannot show is clipped.
glm::vec3 srgbFromRec2020(const render::Color& color);

/// To linear Rec. 2020.
render::Color rec2020FromSrgb(const glm::vec3& srgb);

/// The hue and purity of a colour filter at full brightness, for a button that stands for it. Black where the
/// filter lets nothing through.
glm::vec3 swatchOf(const fixtures::ColorCie& color);

}  // namespace hazer::app
