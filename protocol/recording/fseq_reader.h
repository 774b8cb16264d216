// Sequences of xLights and the Falcon Player: FSEQ 1.x and 2.x.
#pragma once

#include <filesystem>
#include <memory>

#include "protocol/recording/recording.h"

namespace hazer::protocol {

/// Opens a sequence. FSEQ numbers channels, not universes: `map` says how many channels make a universe and
/// what the first is called. Every frame gives every universe of which it has a channel. Throws
/// RecordingError.
std::unique_ptr<RecordingReader> openFseq(const std::filesystem::path& file, const FrameMap& map);

}  // namespace hazer::protocol
