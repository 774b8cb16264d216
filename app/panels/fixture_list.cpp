#include "app/panels/fixture_list.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/panels/fader_row.h"

namespace hazer::app {
namespace {

void drawFixture(const PatchedFixture& patched, std::size_t index, WindowState& state) {
    const fixtures::Fixture& fixture = patched.fixture;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const bool isHeld = state.held.holdsAny(fixture);
    if (isHeld) ImGui::PushStyleColor(ImGuiCol_Text, kHeldColor);
    if (ImGui::Selectable(fixture.name().c_str(), index == state.selected,
                          ImGuiSelectableFlags_SpanAllColumns)) {
        state.selected = index;
    }
    if (isHeld) ImGui::PopStyleColor();
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", fixture.type().name.c_str());
    ImGui::TableNextColumn();
    const auto universe = firstUniverse(patched);
    if (universe) ImGui::TextDisabled("%d.%d", static_cast<int>(universe->number), fixture.address());
}

void drawReleaseAll(Patch& patch, WindowState& state) {
    const bool isIdle = state.held.count() == 0;
    if (isIdle) ImGui::BeginDisabled();
    const std::string label = fmt::format("release all ({})###release all", state.held.count());
    if (ImGui::Button(label.c_str(), {-1.0f, 0.0f})) state.held.releaseAll(patch);
    if (isIdle) ImGui::EndDisabled();
}

}  // namespace

void drawFixtureList(Patch& patch, WindowState& state) {
    constexpr std::size_t kVisibleRows = 9;
    const auto rows = static_cast<float>(std::min(kVisibleRows, patch.fixtures().size()));
    const float height = (rows + 1.5f) * ImGui::GetTextLineHeightWithSpacing();
    if (ImGui::BeginTable("fixtures", 3, ImGuiTableFlags_ScrollY, {0.0f, height})) {
        ImGui::TableSetupScrollFreeze(0, 1);
        ImGui::TableSetupColumn("fixture", ImGuiTableColumnFlags_WidthStretch, 1.0f);
        ImGui::TableSetupColumn("type", ImGuiTableColumnFlags_WidthStretch, 1.0f);
        ImGui::TableSetupColumn("universe.slot", ImGuiTableColumnFlags_WidthStretch, 0.8f);
        ImGui::TableHeadersRow();
        for (std::size_t i = 0; i < patch.fixtures().size(); ++i) drawFixture(patch.fixtures()[i], i, state);
        ImGui::EndTable();
    }
    drawReleaseAll(patch, state);
}

}  // namespace hazer::app
