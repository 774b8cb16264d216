// A recording that plays as if a desk sent it: [[input]] with protocol = "file" in the show file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

#include "protocol/recording/recording.h"
#include "protocol/universe_merger.h"

namespace hazer::app {

class TomlReader;

/// What says how far a recording has come.
enum class PlaybackClock : std::uint8_t {
    kShow,      ///< It plays by itself, in the time of the show.
    kTimeCode,  ///< It is where the time code of Art-Net says.
};

struct ShowRecording {
    std::filesystem::path file;  ///< Relative to the folder of the show as written, absolute here.
    protocol::FrameMap map{};    ///< For files that know no network.
    bool loops = false;
    protocol::RecordingTime from{};  ///< Where it begins.
    protocol::MergeRules merging{};  ///< Of the sources in the file, and of the file with the network.
    PlaybackClock clock = PlaybackClock::kShow;
    protocol::RecordingTime timeCodeStart{};  ///< The time code at which the recording begins.
    std::size_t line = 0;                     ///< In the show file.
};

/// Whether an [[input]] is a file rather than a network or a USB interface.
bool isRecordingInput(TomlReader& input);

/// Reads one. Throws ShowError.
ShowRecording readRecording(TomlReader& reader, const std::filesystem::path& folder);

}  // namespace hazer::app
