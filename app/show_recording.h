// A recording that plays as if a desk sent it: [[input]] with protocol = "file" in the show file.
#pragma once

#include <filesystem>

#include "protocol/recording/recording.h"

namespace hazer::app {

class TomlReader;

struct ShowRecording {
    std::filesystem::path file;  ///< Relative to the folder of the show as written, absolute here.
    protocol::FrameMap map{};    ///< For files that know no network.
    bool loops = false;
    protocol::RecordingTime from{};  ///< Where it begins.
};

/// Whether an [[input]] is a file rather than a network or a USB interface.
bool isRecordingInput(TomlReader& input);

/// Reads one. Throws ShowError.
ShowRecording readRecording(TomlReader& reader, const std::filesystem::path& folder);

}  // namespace hazer::app
