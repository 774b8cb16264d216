// Moments of a recording as people write them.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace hazer::app {

/// Seconds or [h:]m:s, each with a fraction of seconds: "80", "1:20", "1:02:03.5". Nothing if it is none, or
/// more than a hundred days. Behind a colon, seconds and minutes must be below 60.
std::optional<std::chrono::nanoseconds> parseMoment(std::string_view text);

/// "1:02:03.5", "1:20.0": tenths of a second.
std::string momentText(std::chrono::nanoseconds moment);

}  // namespace hazer::app
