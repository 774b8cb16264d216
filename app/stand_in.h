// Which fixture of hazer's library stands in for one whose file says nothing of its light.
#pragma once

#include <string>
#include <string_view>

#include "fixtures/fixture_type.h"

namespace hazer::app {

/// Whether a mode is only a placeholder that a program exported: channels without meaning ("Dummy",
/// "Dimmer12"), or light attributes and no beam that they could act on. A hazer or a truss, which has no beam
/// either, is none.
bool isDummy(const fixtures::DmxMode& mode);

/// The library fixture of the same kind, judged by the attributes of `mode` (null: unknown), by words in
/// `name`, and by the number of slots.
std::string standInFor(std::string_view name, const fixtures::DmxMode* mode);

/// The mode that takes the most slots, but no more than `slots`, so that it does not read its neighbour's.
/// With 0 slots, which means unknown, the first. Null if none fits.
const fixtures::DmxMode* modeFitting(const fixtures::FixtureType& type, int slots);

/// The library fixture that fits everywhere: a dimmer.
std::string smallestStandIn();

}  // namespace hazer::app
