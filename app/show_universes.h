// Which universes a show is patched to, and which of them a receiver has to ask for.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "app/show.h"
#include "protocol/dmx.h"

namespace hazer::app {

/// Each universe that drives a fixture of the show, once, ascending.
std::vector<protocol::UniverseId> universesOf(const Show& show);

/// The numbers of those that are on `transport` (kArtNet or kSacn), Transport::kAny included; what the
/// transport has no such number for is left out.
std::vector<std::uint16_t> numbersOn(protocol::Transport transport,
                                     std::span<const protocol::UniverseId> universes);

}  // namespace hazer::app
