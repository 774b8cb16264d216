#include "app/panels/usb_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <string>

#include "app/usb_text.h"

namespace hazer::app {
namespace {

using protocol::UsbLineStatus;

/// "DMX USB Pro 1.44, socket 1-1.2, serial EN123456".
std::string detailsOf(const UsbLineStatus& line) {
    std::string details = line.facts.kind;
    if (!line.facts.firmware.empty()) details += " " + line.facts.firmware;
    if (!details.empty()) details += ", ";
    return details + fmt::format("socket {}, serial {}", line.socket, line.key);
}

void drawCounts(const protocol::UsbWidgetFacts& facts) {
    ImGui::BulletText("%s", fmt::format("{} frames, {} lost, {} other start codes, {} malformed",
                                        facts.frames, facts.lostFrames, facts.otherCodes, facts.malformed)
                                .c_str());
}

}  // namespace

void drawUsb(const Session& session) {
    for (const UsbLineStatus& line : session.inputs().usbDevices()) {
        ImGui::TextWrapped("%s", usbLineText(line).c_str());
        ImGui::TextDisabled("%s", detailsOf(line).c_str());
        if (line.problem.empty()) drawCounts(line.facts);
    }
}

}  // namespace hazer::app
