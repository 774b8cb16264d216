// Gauss' quadrature rules with a soft beam's profile as their weight, see integrateSoft in
// shaders/include/beam_integral.glsl.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "render/photometry.h"

namespace hazer::render {

/// Columns of a table of rules: chords through the axis first, along the rim last.
inline constexpr int kProfileRuleColumns = 128;

/// So many profiles have rules at once; a row each.
inline constexpr int kProfileRuleRows = 256;

/// Is a profile soft, and narrow enough (34 degrees) that the tangent is a good variable?
bool hasProfileRules(const BeamShape& shape);

/// The rules for one profile: in column i the sine of the chord's smallest angle from the axis is
/// i / (kProfileRuleColumns - 1) of the sine of the cut. Nodes +-x, +-y over -1..1 and their weights v, w as
/// (x, y, v, w); the rule is exact for polynomials up to the seventh degree times the profile.
std::vector<glm::vec4> profileRules(const BeamShape& shape);

}  // namespace hazer::render
