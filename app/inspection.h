// What is in a fixture type or a show, as JSON for machines and as text for people.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/attribute_values.h"
#include "app/patch.h"
#include "fixtures/fixture_type.h"

namespace hazer::app {

/// {"name", "manufacturer", "modes": [{"name", "footprint": {break: slots}, "channels": [{"geometry",
/// "attribute", "break", "offsets", "functions": [{"name", "attribute", "from", "to", "physical_from",
/// "physical_to", "wheel", "sets": [{"name", "from", "to", "physical_from", "physical_to", "wheel_slot",
/// "slot_name"}]}]}], "beams": [{"path", "position_m", "direction"}]}], "wheels": [{"name", "slots":
/// [names]}], "warnings": [sentences]}. Beams stand as in the fixture's own coordinates, at rest or where
/// `values` bring them; a mode leaves out what it has no attribute for. Throws std::runtime_error if no mode
/// has one.
nlohmann::ordered_json describeFixtureType(const fixtures::FixtureTypePtr& type,
                                           const AttributeValues& values = {});

/// {"fixtures": [{"name", "gdtf", "mode", "protocol", "universe", "breaks": of several, [{"break",
/// "protocol", "universe", "slot"}], "slots": {attribute: [slots from 1, most significant first]}}],
/// "lights": [{"name", "position_m", "direction", "candela" or "lumen", "half_angle_deg" or "web"}]}. Where
/// several channels have one attribute, its key is "geometry.attribute" from the second on.
nlohmann::ordered_json describeShow(const Show& show, const Patch& patch);

/// The same for people: a title, then a line for each mode and wheel, with the names of macros and effects,
/// or each fixture and bare light.
std::string summarizeFixtureType(const fixtures::FixtureType& type);
std::string summarizeShow(const Show& show, const Patch& patch);

}  // namespace hazer::app
