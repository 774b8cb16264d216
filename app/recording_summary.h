// What stands at a moment of a recording, as JSON for machines and as text for people.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "protocol/recording/recording_player.h"

namespace hazer::app {

/// {"duration_s", "packets", "refused", "universes": [{"protocol": "artnet|sacn|dmx", "universe", "packets",
/// "sources": [{"name", "address", "priority"}], "slots": [512 levels]}]}. All but the duration is as it
/// stands at the player's moment; `durationS` is that of the whole recording.
nlohmann::ordered_json describeRecording(protocol::RecordingPlayer& player, double durationS);

/// The same for people: a line for the whole, a line for each universe and each of its sources.
std::string summarizeRecording(protocol::RecordingPlayer& player, double durationS);

}  // namespace hazer::app
