#include "app/panels/wheel_row.h"

#include <imgui.h>

#include <cmath>

#include "app/panels/fader_row.h"
#include "app/window_color.h"
#include "fixtures/attribute.h"

namespace hazer::app {
namespace {

int slotOf(const Fader& fader, const fixtures::Fixture& fixture) {
    return static_cast<int>(std::lround(fixture.value(fader.attribute).value_or(1.0)));
}

bool drawColorButton(const fixtures::WheelSlot& slot, const ImVec2& size) {
    const glm::vec3 swatch = swatchOf(slot.color);
    return ImGui::ColorButton("##slot", {swatch.r, swatch.g, swatch.b, 1.0f}, ImGuiColorEditFlags_NoTooltip,
                              size);
}

bool drawSlotButton(const fixtures::WheelSlot& slot, float edge, WindowThumbnails& thumbnails) {
    if (slot.image == nullptr) return drawColorButton(slot, {edge, edge});
    constexpr int kNoPadding = 0;
    const ImVec4 behind{0.0f, 0.0f, 0.0f, 1.0f};
    return ImGui::ImageButton(thumbnails.textureOf(slot.image), {edge, edge}, {0.0f, 0.0f}, {1.0f, 1.0f},
                              kNoPadding, behind);
}

void frameLastItem() {
    const float thickness = 0.12f * ImGui::GetFontSize();
    ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                        IM_COL32(255, 255, 255, 255), 2.0f, 0, thickness);
}

/// Breaks the line where the next button would not fit.
void placeNext(float edge, float gap, float right) {
    if (ImGui::GetItemRectMax().x + gap + edge < right) ImGui::SameLine(0.0f, gap);
}

void drawSlotButtons(const Fader& fader, fixtures::Fixture& fixture, HeldFaders& held,
                     WindowThumbnails& thumbnails) {
    const float edge = 2.2f * ImGui::GetFontSize();
    const float gap = 0.25f * ImGui::GetFontSize();
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    const int chosen = slotOf(fader, fixture);
    const int count = static_cast<int>(fader.wheel->slots.size());
    for (int number = 1; number <= count; ++number) {
        const fixtures::WheelSlot& slot = fader.wheel->slots[static_cast<std::size_t>(number - 1)];
        ImGui::PushID(number);
        if (drawSlotButton(slot, edge, thumbnails)) held.hold(fixture, fader.attribute, number);
        if (number == chosen) frameLastItem();
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%d  %s", number, slot.name.c_str());
        if (number < count) placeNext(edge, gap, right);
        ImGui::PopID();
    }
}

/// A box that takes the gobo out of the light and puts it back.
void drawGoboSwitch(const Fader& fader, fixtures::Fixture& fixture, HeldFaders& held, int& lastGobo) {
    const int slot = slotOf(fader, fixture);
    bool isOn = isGobo(*fader.wheel, slot);
    if (isOn) lastGobo = slot;
    if (ImGui::Checkbox("on", &isOn)) {
        held.hold(fixture, fader.attribute, slotAfterGoboSwitch(*fader.wheel, slot, lastGobo));
    }
}

}  // namespace

void drawColorWheelRow(const Fader& fader, fixtures::Fixture& fixture, HeldFaders& held,
                       WindowThumbnails& thumbnails) {
    drawRow(fader, fixture, held, [&] { drawSlotButtons(fader, fixture, held, thumbnails); });
}

void drawGoboWheelRow(const Fader& fader, fixtures::Fixture& fixture, HeldFaders& held,
                      WindowThumbnails& thumbnails, std::map<std::string, int>& lastGobos) {
    drawRow(fader, fixture, held, [&] {
        drawGoboSwitch(fader, fixture, held, lastGobos[fixture.name() + '/' + fader.attribute]);
        drawSlotButtons(fader, fixture, held, thumbnails);
    });
}

}  // namespace hazer::app
