#include "app/show_recording.h"

#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

#include "app/moment.h"
#include "app/show_input.h"
#include "app/toml_reader.h"
#include "protocol/printable_text.h"

namespace hazer::app {
namespace {

// In the order of kFrameTransports.
const std::vector<std::string> kFrameProtocols{"artnet", "sacn", "dmx"};
constexpr std::array kFrameTransports{protocol::Transport::kArtNet, protocol::Transport::kSacn,
                                      protocol::Transport::kDmx};

const std::vector<std::string> kClocks{"show", "timecode"};  // of PlaybackClock

protocol::RecordingTime readMoment(TomlReader& reader, std::string_view key) {
    const std::string text = reader.text(key, "0");
    if (const auto moment = parseMoment(text)) return *moment;
    reader.fail(fmt::format("{} is '{}', which is no time; write \"80\", \"1:20\" or \"1:02:03.5\"", key,
                            protocol::printableText(text)));
}

void readClock(TomlReader& reader, ShowRecording& recording) {
    recording.clock = static_cast<PlaybackClock>(reader.choice("follow", kClocks, 0));
    const bool followsCode = recording.clock == PlaybackClock::kTimeCode;
    if (!followsCode && reader.has("timecode_start")) {
        reader.fail("timecode_start does nothing unless follow is \"timecode\"; set that or take it out");
    }
    recording.timeCodeStart = readMoment(reader, "timecode_start");
    if (followsCode && recording.loops) {
        reader.fail("a file that follows the time code cannot loop by itself; take loop or follow out");
    }
}

}  // namespace

bool isRecordingInput(TomlReader& input) {
    return input.has("protocol") && input.text("protocol", "") == "file";
}

ShowRecording readRecording(TomlReader& reader, const std::filesystem::path& folder) {
    ShowRecording recording;
    recording.file = folder / reader.requiredText("path");
    recording.map.transport = kFrameTransports[reader.choice("as", kFrameProtocols, 0)];
    recording.map.firstUniverse =
        static_cast<std::uint16_t>(reader.integer("first_universe", recording.map.firstUniverse, {0, 65535}));
    recording.map.slotsPerUniverse = static_cast<std::uint16_t>(
        reader.integer("slots_per_universe", recording.map.slotsPerUniverse, {1, 512}));
    recording.loops = reader.flag("loop", false);
    recording.merging = readMerging(reader);
    recording.line = reader.line();
    readClock(reader, recording);
    reader.refuseUnknownKeys();
    return recording;
}

}  // namespace hazer::app
