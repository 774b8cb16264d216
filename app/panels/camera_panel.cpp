#include "app/panels/camera_panel.h"

#include <fmt/format.h>
#include <imgui.h>

namespace hazer::app {
namespace {

void drawSavedCameras(const Show& show, WindowState& state) {
    for (std::size_t i = 0; i < show.cameras.size(); ++i) {
        const std::string label = fmt::format("{}  {}##{}", i + 1, show.cameras[i].name, i);
        if (ImGui::Button(label.c_str(), {-1.0f, 0.0f})) state.camera = OrbitCamera(show.cameras[i].camera);
    }
}

double aspectOfWindow() {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    return static_cast<double>(size.x) / static_cast<double>(size.y);
}

}  // namespace

void drawCameraControls(const Show& show, WindowState& state) {
    drawSavedCameras(show, state);
    if (ImGui::Button("frame the stage", {-1.0f, 0.0f})) {
        state.camera.frame(state.stage.centreM, state.stage.radiusM, aspectOfWindow());
    }
    double fovDeg = glm::degrees(state.camera.verticalFovRad());
    constexpr double kNarrowestDeg = 3.0;
    constexpr double kWidestDeg = 140.0;
    if (ImGui::SliderScalar("field of view", ImGuiDataType_Double, &fovDeg, &kNarrowestDeg, &kWidestDeg,
                            "%.0f deg", ImGuiSliderFlags_AlwaysClamp)) {
        state.camera.setVerticalFov(glm::radians(fovDeg));
    }
    const glm::dvec3 placeM = state.camera.camera().positionM;
    ImGui::TextDisabled("at %.1f, %.1f, %.1f m", placeM.x, placeM.y, placeM.z);
}

}  // namespace hazer::app
