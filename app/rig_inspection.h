// What is in a rig (MVR), as JSON for machines and as text for people.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "fixtures/mvr_scene.h"

namespace hazer::app {

/// {"fixtures": [{"name", "gdtf", "mode", "addresses": [{"break", "universe", "slot"}], "position_m",
/// "direction"}], "objects": number of all others but groups, "warnings": [sentences]}. Breaks and universes
/// are numbers from 1; the direction is that of a beam that hangs straight down from the fixture.
nlohmann::ordered_json describeRig(const fixtures::MvrScene& scene, const std::vector<std::string>& warnings);

/// The same for people: a title, then a line for each fixture and warning.
std::string summarizeRig(const fixtures::MvrScene& scene, const std::vector<std::string>& warnings);

}  // namespace hazer::app
