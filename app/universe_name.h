// What universes are called in show files, JSON, tables and sentences.
#pragma once

#include <string>
#include <string_view>

#include "protocol/dmx.h"

namespace hazer::app {

/// "artnet", "sacn", "dmx" or "any", as in a show.
std::string_view protocolName(protocol::Transport transport);

/// "Port-Address 5", "sACN universe 5", "DMX line 5" or "universe 5".
std::string describeUniverse(protocol::UniverseId universe);

/// "Art-Net 291 (1:2:3)", "sACN 5", "DMX 5" or "any 5", for tables.
std::string universeLabel(protocol::UniverseId universe);

}  // namespace hazer::app
