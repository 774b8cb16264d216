// Made-up levels to send when there is no desk.
#pragma once

#include <optional>
#include <string_view>

#include "protocol/dmx.h"

namespace hazer::protocol {

enum class Pattern : std::uint8_t {
    kChase,   ///< Every eighth slot full, one slot further eight times a second.
    kSine,    ///< A wave along the slots, 16 slots long, passing every two seconds.
    kStrobe,  ///< All slots full, then all 0, five times a second.
    kFull,    ///< All slots full.
};

/// Writes all 512 slots of the pattern at timeS [s] since its start. The same time always gives the same
/// slots; finite, any sign.
void fillPattern(Pattern pattern, double timeS, Slots& slots);

/// "chase", "sine", "strobe" or "full"; anything else is no pattern.
std::optional<Pattern> patternFromName(std::string_view name);

}  // namespace hazer::protocol
