#include "app/usb_text.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string_view>

#include "app/universe_name.h"

namespace hazer::app {
namespace {

std::string_view stateName(protocol::UsbState state) {
    switch (state) {
        case protocol::UsbState::kStarting:
            return "starting";
        case protocol::UsbState::kReceiving:
            return "receiving";
        case protocol::UsbState::kSilent:
            return "silent";
        case protocol::UsbState::kFailed:
            break;
    }
    return "failed";
}

}  // namespace

std::string usbLineText(const protocol::UsbLineStatus& line) {
    if (!line.problem.empty()) return line.problem;
    return fmt::format("{}: {}, {}", describeUniverse(line.universe), line.name, stateName(line.state));
}

nlohmann::ordered_json usbLineJson(const protocol::UsbLineStatus& line) {
    return {{"serial", line.key},
            {"name", line.name},
            {"socket", line.socket},
            {"kind", line.facts.kind},
            {"firmware", line.facts.firmware},
            {"universe", line.universe.number},
            {"state", stateName(line.state)},
            {"problem", line.problem},
            {"frames", line.facts.frames},
            {"lost_frames", line.facts.lostFrames},
            {"other_start_codes", line.facts.otherCodes},
            {"malformed", line.facts.malformed}};
}

}  // namespace hazer::app
