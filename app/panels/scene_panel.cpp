#include "app/panels/scene_panel.h"

#include <imgui.h>

#include <optional>

#include "app/window_color.h"
#include "app/window_haze.h"

namespace hazer::app {
namespace {

constexpr ImGuiSliderFlags kLogarithmic = ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp;
constexpr ImGuiSliderFlags kLinear = ImGuiSliderFlags_AlwaysClamp;

void drawAmbient(render::Ambient& ambient) {
    glm::vec3 shown = srgbFromRec2020(ambient.color);
    if (ImGui::ColorEdit3("scene colour", &shown.x, ImGuiColorEditFlags_NoInputs)) {
        ambient.color = rec2020FromSrgb(shown);
    }
    ImGui::SliderFloat("scene light", &ambient.illuminanceLx, 0.0f, 1000.0f, "%.2f lx", kLogarithmic);
}

/// A slider for something that each object has its own of, until this one sets it for all.
void drawForAll(const char* label, std::optional<float>& forAll, float usual, float from, float to,
                const char* format, ImGuiSliderFlags flags) {
    float value = forAll.value_or(usual);
    if (ImGui::SliderFloat(label, &value, from, to, forAll ? format : "each its own", flags)) forAll = value;
}

}  // namespace

void drawHazeControls(SceneControls& controls, const SceneControls& ofShow) {
    render::Haze& haze = controls.haze;
    float extinction = haze.extinctionPerM;
    if (ImGui::SliderFloat("attenuation", &extinction, 0.0f, 1.0f, "%.4f /m", kLogarithmic)) {
        setExtinction(haze, extinction);
    }
    ImGui::SliderFloat("smoke", &haze.noise.amount, 0.0f, 1.0f, "%.2f", kLinear);
    ImGui::SliderFloat("swirl size", &haze.noise.scaleM, 0.2f, 20.0f, "%.1f m", kLogarithmic);
    ImGui::SliderFloat3("wind [m/s]", &haze.noise.windMps.x, -2.0f, 2.0f, "%.2f", kLinear);
    if (ImGui::Button("as in the show##haze")) haze = ofShow.haze;
}

void drawSetControls(SceneControls& controls, const SceneControls& ofShow) {
    const render::Material usual;
    drawAmbient(controls.ambient);
    drawForAll("specular", controls.specular, usual.specular, 0.0f, 1.0f, "%.2f", kLinear);
    drawForAll("shininess", controls.shininess, usual.shininess, 1.0f, 1000.0f, "%.0f", kLogarithmic);
    ImGui::Checkbox("further objects", &controls.furtherObjects);
    if (ImGui::Button("as in the show##set")) {
        const render::Haze haze = controls.haze;
        controls = ofShow;
        controls.haze = haze;
    }
}

}  // namespace hazer::app
