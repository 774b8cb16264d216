// USB interfaces in words.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "protocol/usb/usb_input.h"

namespace hazer::app {

/// "DMX line 1: ENTTEC DMX USB PRO, receiving", or the one sentence that says why it cannot be used.
std::string usbLineText(const protocol::UsbLineStatus& line);

/// {"serial", "name", "socket", "kind", "firmware", "universe", "state": "starting|receiving|silent|failed",
/// "problem", "frames", "lost_frames", "other_start_codes", "malformed"}
nlohmann::ordered_json usbLineJson(const protocol::UsbLineStatus& line);

}  // namespace hazer::app
