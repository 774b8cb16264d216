#include "app/panels/fader_row.h"

#include <fmt/format.h>
#include <imgui.h>

namespace hazer::app {
namespace {

static_assert(kHeldColor == IM_COL32(255, 190, 80, 255));

constexpr const char* kPercent = "%";

/// What people read for a value: shares are shown in percent.
double shownPerUnit(const Fader& fader) {
    return fader.unit == kPercent ? 100.0 : 1.0;
}

std::string formatOf(const Fader& fader) {
    return fader.unit == kPercent ? "%.1f %%" : "%.1f " + fader.unit;
}

void drawLabel(const Fader& fader, bool isHeld) {
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    if (isHeld) ImGui::PushStyleColor(ImGuiCol_Text, kHeldColor);
    ImGui::TextUnformatted(fader.label.c_str());
    if (isHeld) ImGui::PopStyleColor();
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("GDTF attribute %s", fader.attribute.c_str());
}

void drawReleaseButton(const Fader& fader, fixtures::Fixture& fixture, HeldFaders& held) {
    ImGui::TableNextColumn();
    if (!held.isHeld(fixture, fader.attribute)) return;
    if (ImGui::Button("x")) held.release(fixture, fader.attribute);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Release: DMX moves it again");
}

}  // namespace

void drawFaderTable(const char* id, const std::function<void()>& draw) {
    if (!ImGui::BeginTable(id, 3)) return;
    const float em = ImGui::GetFontSize();
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, 6.5f * em);
    ImGui::TableSetupColumn("control", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("release", ImGuiTableColumnFlags_WidthFixed, 1.5f * em);
    draw();
    ImGui::EndTable();
}

void drawRow(const Fader& fader, fixtures::Fixture& fixture, HeldFaders& held,
             const std::function<void()>& draw) {
    ImGui::PushID(fader.attribute.c_str());
    ImGui::TableNextRow();
    drawLabel(fader, held.isHeld(fixture, fader.attribute));
    ImGui::TableNextColumn();
    ImGui::SetNextItemWidth(-1.0f);
    draw();
    drawReleaseButton(fader, fixture, held);
    ImGui::PopID();
}

void drawSliderRow(const Fader& fader, fixtures::Fixture& fixture, HeldFaders& held) {
    drawRow(fader, fixture, held, [&] {
        const double scale = shownPerUnit(fader);
        const double from = fader.from * scale;
        const double to = fader.to * scale;
        double shown = fixture.value(fader.attribute).value_or(fader.from) * scale;
        if (ImGui::SliderScalar("##slider", ImGuiDataType_Double, &shown, &from, &to, formatOf(fader).c_str(),
                                ImGuiSliderFlags_AlwaysClamp)) {
            held.hold(fixture, fader.attribute, shown / scale);
        }
    });
}

}  // namespace hazer::app
