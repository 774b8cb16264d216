// Colours between CIE XYZ, Rec. 709 (what people write in show files) and Rec. 2020 (what the renderer has).
// All linear, D65.
#pragma once

#include <glm/glm.hpp>

#include "render/scene.h"

namespace hazer::app {

/// Share of each Rec. 2020 primary in luminance (ITU-R BT.2020-2, table 4).
double luminance(const glm::dvec3& rec2020);

/// From linear Rec. 709 (ITU-R BT.2087-0). White stays white; luminance stays.
render::Color rec2020FromRec709(const glm::dvec3& rec709);

/// From CIE XYZ, white D65 at XYZ (0.9505, 1, 1.089). May have negative components: a colour outside Rec.
/// 2020.
glm::dvec3 rec2020FromXyz(const glm::dvec3& xyz);

/// The colour of a light with luminance 1, inside Rec. 2020: what lies outside is moved towards white of the
/// same luminance just far enough. Black for light without luminance.
render::Color lightColorFromXyz(const glm::dvec3& xyz);

}  // namespace hazer::app
