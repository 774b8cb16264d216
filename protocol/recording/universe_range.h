// What the universes of a file that knows no network are called.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "protocol/recording/recording.h"

namespace hazer::protocol {

/// Universe `number` of the file (it counts from 1; OLA also has 0), or nothing if its transport has no such
/// universe: Art-Net 0..32767, sACN 1..63999, DMX 0..65535.
std::optional<UniverseId> universeAt(const FrameMap& map, std::uint32_t number);

/// A sentence for when it has none.
std::string outOfRange(const FrameMap& map, std::uint32_t number);

}  // namespace hazer::protocol
