#include "app/panels/side_panels.h"

#include <imgui.h>

#include "app/panels/camera_panel.h"
#include "app/panels/fader_panel.h"
#include "app/panels/fixture_list.h"
#include "app/panels/network_panel.h"
#include "app/panels/picture_panel.h"
#include "app/panels/player_panel.h"
#include "app/panels/scene_panel.h"
#include "app/panels/timing_panel.h"
#include "app/panels/usb_panel.h"

namespace hazer::app {
namespace {

constexpr float kLeftWidthEm = 23.0f;
constexpr float kRightWidthEm = 20.0f;
constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus;

void placeColumn(float left, float width) {
    ImGui::SetNextWindowPos({left, 0.0f});
    ImGui::SetNextWindowSize({width, ImGui::GetIO().DisplaySize.y});
}

/// A section that starts open; a person may fold it away.
bool beginSection(const char* title) {
    return ImGui::CollapsingHeader(title, ImGuiTreeNodeFlags_DefaultOpen);
}

void drawFixtureColumn(Session& session, WindowState& state, WindowThumbnails& thumbnails) {
    auto& fixtures = session.patch().fixtures();
    if (fixtures.empty()) {
        ImGui::TextWrapped("This show has no fixtures.");
        return;
    }
    drawFixtureList(session.patch(), state);
    ImGui::BeginChild("faders");
    drawFaderPanel(fixtures[state.selected].fixture, state, thumbnails);
    ImGui::EndChild();
}

void drawSceneColumn(Session& session, WindowState& state) {
    ImGui::TextDisabled("H: help    Tab: panels");
    ImGui::PushItemWidth(0.58f * ImGui::GetContentRegionAvail().x);
    if (beginSection("Haze")) drawHazeControls(session.controls(), state.controlsOfShow);
    if (beginSection("Scene")) drawSetControls(session.controls(), state.controlsOfShow);
    if (beginSection("Picture")) drawPictureControls(session.settings(), state.resolution);
    if (beginSection("Camera")) drawCameraControls(session.show(), state);
    if (beginSection("Times")) drawTimings(session, state.frameTimes);
    if (!session.playbacks().empty() && beginSection("Recordings")) drawPlayers(session);
    if (beginSection("Network")) drawNetwork(session);
    if (!session.inputs().usbDevices().empty() && beginSection("USB")) drawUsb(session);
    ImGui::PopItemWidth();
}

}  // namespace

void drawSidePanels(Session& session, WindowState& state, WindowThumbnails& thumbnails) {
    const float em = ImGui::GetFontSize();
    placeColumn(0.0f, kLeftWidthEm * em);
    if (ImGui::Begin("Fixtures", nullptr, kFixed)) drawFixtureColumn(session, state, thumbnails);
    ImGui::End();
    placeColumn(ImGui::GetIO().DisplaySize.x - kRightWidthEm * em, kRightWidthEm * em);
    if (ImGui::Begin("Scene", nullptr, kFixed)) drawSceneColumn(session, state);
    ImGui::End();
}

}  // namespace hazer::app
