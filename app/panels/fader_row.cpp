#include "app/panels/fader_row.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

namespace hazer::app {
namespace {

static_assert(kHeldColor == IM_COL32(255, 190, 80, 255));

constexpr const char* kPercent = "%";

/// What people read for a value: shares are shown in percent.
double shownPerUnit(const Fader& fader) {
    return fader.unit == kPercent ? 100.0 : 1.0;
}

/// The name that the file has for where the fader stands; "" for none.
std::string nameAt(const Fader& fader, const fixtures::Fixture& fixture) {
    const fixtures::ChannelSet* const set = fixture.set(fader.attribute);
    return set == nullptr ? "" : set->name;
}

std::string withoutFormats(std::string text) {
    std::ranges::replace(text, '%', ' ');
    return text;
}

/// For ImGui, which writes the value in place of "%.1f".
std::string formatOf(const Fader& fader, const std::string& name) {
    const std::string value = fader.unit == kPercent ? "%.1f %%" : "%.1f " + fader.unit;
    return name.empty() ? value : value + "  " + withoutFormats(name);
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

void drawNameRow(const Fader& fader, fixtures::Fixture& fixture, HeldFaders& held) {
    drawRow(fader, fixture, held, [&] {
        const std::string current = nameAt(fader, fixture);
        if (!ImGui::BeginCombo("##names", current.c_str())) return;
        for (std::size_t index = 0; index < fader.names.size(); ++index) {
            const NamedFaderValue& named = fader.names[index];
            ImGui::PushID(static_cast<int>(index));
            if (ImGui::Selectable(named.name.c_str(), named.name == current)) {
                held.hold(fixture, fader.attribute, named.value);
            }
            ImGui::PopID();
        }
        ImGui::EndCombo();
    });
}

void drawSliderRow(const Fader& fader, fixtures::Fixture& fixture, HeldFaders& held) {
    drawRow(fader, fixture, held, [&] {
        const double scale = shownPerUnit(fader);
        const double from = fader.from * scale;
        const double to = fader.to * scale;
        double shown = fixture.value(fader.attribute).value_or(fader.from) * scale;
        if (ImGui::SliderScalar("##slider", ImGuiDataType_Double, &shown, &from, &to,
                                formatOf(fader, nameAt(fader, fixture)).c_str(),
                                ImGuiSliderFlags_AlwaysClamp)) {
            held.hold(fixture, fader.attribute, shown / scale);
        }
    });
}

}  // namespace hazer::app
