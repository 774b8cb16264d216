#include "app/show_recording.h"

#include <array>
#include <string>
#include <vector>

#include "app/toml_reader.h"

namespace hazer::app {
namespace {

// In the order of kFrameTransports.
const std::vector<std::string> kFrameProtocols{"artnet", "sacn", "dmx"};
constexpr std::array kFrameTransports{protocol::Transport::kArtNet, protocol::Transport::kSacn,
                                      protocol::Transport::kDmx};

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
    reader.refuseUnknownKeys();
    return recording;
}

}  // namespace hazer::app
