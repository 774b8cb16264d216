#include "app/panels/picture_panel.h"

#include <imgui.h>

namespace hazer::app {
namespace {

void drawResolution(const render::Settings& settings, WindowResolution& resolution) {
    auto factor = static_cast<float>(resolution.factor());
    constexpr auto kMinFactor = static_cast<float>(WindowResolution::kMinFactor);
    if (ImGui::SliderFloat("resolution", &factor, kMinFactor, 1.0f, "%.2f", ImGuiSliderFlags_AlwaysClamp)) {
        resolution.setFactor(static_cast<double>(factor));
    }
    bool isAutomatic = resolution.isAutomatic();
    if (ImGui::Checkbox("automatic", &isAutomatic)) resolution.setAutomatic(isAutomatic);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Coarser while drawing the picture takes more than 50 ms");
    ImGui::SameLine();
    ImGui::TextDisabled("%d x %d", settings.width, settings.height);
}

}  // namespace

void drawPictureControls(render::Settings& settings, WindowResolution& resolution) {
    ImGui::SliderFloat("exposure", &settings.exposureEv100, -2.0f, 18.0f, "EV %.1f");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("EV100: one more halves the brightness");
    ImGui::Checkbox("shadows", &settings.shadows);
    ImGui::SameLine();
    ImGui::Checkbox("gobos", &settings.gobos);
    ImGui::SameLine();
    ImGui::Checkbox("bloom", &settings.bloom);
    drawResolution(settings, resolution);
}

}  // namespace hazer::app
