// The show files of OLA's recorder, both versions.
#pragma once

#include <filesystem>
#include <memory>

#include "protocol/recording/recording.h"

namespace hazer::protocol {

/// Opens a show file and reads it through once to see that it is sound. docs/recordings.md has the format.
/// Throws RecordingError with the line at fault.
std::unique_ptr<RecordingReader> openOlaShow(const std::filesystem::path& file, const FrameMap& map);

}  // namespace hazer::protocol
