// What the commands that read recordings share: moments of time, and what to call universes of files without
// a network.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "protocol/recording/recording.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace hazer::app {

/// Adds an option for a moment, seconds or [h:]m:s with a fraction: 80, 1:20, 1:02:03.5. At most a hundred
/// days.
CLI::Option* addMomentOption(CLI::App& command, const std::string& name,
                             std::optional<std::chrono::nanoseconds>& moment, const std::string& description);

/// --as, --first-universe and --slots-per-universe. `mayBeDmx`: whether `dmx` will do, for universes that go
/// over no network.
void addFrameMapOptions(CLI::App& command, protocol::FrameMap& map, protocol::Transport otherwise,
                        bool mayBeDmx);

}  // namespace hazer::app
