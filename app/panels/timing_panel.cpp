#include "app/panels/timing_panel.h"

#include <imgui.h>

namespace hazer::app {
namespace {

void drawRow(const char* what, double milliseconds) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(what);
    ImGui::TableNextColumn();
    ImGui::Text("%7.2f ms", milliseconds);
}

void drawHistory(const WindowFrameTimes& frameTimes) {
    const auto history = frameTimes.history();
    const float height = 2.5f * ImGui::GetFontSize();
    ImGui::SetNextItemWidth(-1.0f);
    // From 0, so that the line's height means something; the top is twice what the slowest frames take.
    ImGui::PlotLines("##frames", history.data(), static_cast<int>(history.size()), 0, nullptr, 0.0f,
                     2.0f * static_cast<float>(frameTimes.percentile99Ms()), {0.0f, height});
}

}  // namespace

void drawTimings(Session& session, const WindowFrameTimes& frameTimes) {
    drawHistory(frameTimes);
    if (!ImGui::BeginTable("times", 2)) return;
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("time", ImGuiTableColumnFlags_WidthFixed, 6.0f * ImGui::GetFontSize());
    drawRow("frame, median", frameTimes.medianMs());
    drawRow("frame, 99th percentile", frameTimes.percentile99Ms());
    drawRow("DMX and mechanics (CPU)", session.frameTimes().advanceMs);
    drawRow("drawing (CPU)", session.frameTimes().drawMs);
    for (const render::PassTime& pass : session.renderer().passTimes()) {
        drawRow(pass.name.c_str(), pass.milliseconds);
    }
    ImGui::EndTable();
}

}  // namespace hazer::app
