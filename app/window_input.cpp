#include "app/window_input.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <optional>

#include "app/window_picking.h"

namespace hazer::app {
namespace {

glm::dvec2 pictureSize() {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    return {size.x, size.y};
}

/// Where a fixture is for the eye: its lens, or its first part if it has no beam.
glm::dvec3 placeOf(const fixtures::Fixture& fixture) {
    const fixtures::FixtureState state = fixture.state();
    if (!state.beams.empty()) return glm::dvec3(state.beams.front().worldFromBeam[3]);
    if (!state.parts.empty()) return glm::dvec3(state.parts.front().worldFromPart[3]);
    return glm::dvec3(0.0);
}

void selectAt(const glm::dvec2& place, Session& session, WindowState& state) {
    const double reach = 2.0 * static_cast<double>(ImGui::GetFontSize());
    std::vector<glm::dvec3> placesM;
    for (const PatchedFixture& patched : session.patch().fixtures())
        placesM.push_back(placeOf(patched.fixture));
    const std::optional<std::size_t> found =
        pointAt(state.camera.camera(), pictureSize(), place, reach, placesM);
    if (found) state.selected = *found;
}

/// A left button that goes up where it went down was a click, not a drag.
bool wasClicked(const ImGuiIO& io) {
    const float threshold = io.MouseDragThreshold;
    return ImGui::IsMouseReleased(ImGuiMouseButton_Left) && !io.MouseDownOwned[ImGuiMouseButton_Left] &&
           io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] < threshold * threshold;
}

void showSavedCamera(const Show& show, std::size_t index, WindowState& state) {
    if (index < show.cameras.size()) state.camera = OrbitCamera(show.cameras[index].camera);
}

}  // namespace

void followMouse(Session& session, WindowState& state) {
    const ImGuiIO& io = ImGui::GetIO();
    if (wasClicked(io)) selectAt({io.MousePos.x, io.MousePos.y}, session, state);
    if (io.WantCaptureMouse) return;
    const glm::dvec2 drag = glm::dvec2(io.MouseDelta.x, io.MouseDelta.y) / pictureSize().y;
    if (ImGui::IsMouseDragging(ImGuiMouseButton_Left)) state.camera.orbit(drag);
    if (ImGui::IsMouseDown(ImGuiMouseButton_Right) || ImGui::IsMouseDown(ImGuiMouseButton_Middle)) {
        state.camera.pan(drag);
    }
    state.camera.dolly(static_cast<double>(io.MouseWheel));
}

void followKeys(const std::vector<Key>& keys, const Show& show, WindowState& state) {
    if (ImGui::GetIO().WantTextInput) return;
    const glm::dvec2 size = pictureSize();
    for (const Key key : keys) {
        if (key == GLFW_KEY_TAB) state.showsPanels = !state.showsPanels;
        if (key == GLFW_KEY_H) state.showsHelp = !state.showsHelp;
        if (key == GLFW_KEY_F) state.camera.frame(state.stage.centreM, state.stage.radiusM, size.x / size.y);
        if (key >= GLFW_KEY_1 && key <= GLFW_KEY_9) {
            showSavedCamera(show, static_cast<std::size_t>(key - GLFW_KEY_1), state);
        }
    }
}

void markSelected(Session& session, const WindowState& state) {
    const auto& fixtures = session.patch().fixtures();
    if (state.selected >= fixtures.size()) return;
    const std::optional<glm::dvec2> place =
        placeInPicture(state.camera.camera(), pictureSize(), placeOf(fixtures[state.selected].fixture));
    if (!place) return;
    const ImVec2 centre(static_cast<float>(place->x), static_cast<float>(place->y));
    constexpr ImU32 kMark = IM_COL32(255, 190, 80, 200);
    ImGui::GetBackgroundDrawList()->AddCircle(centre, ImGui::GetFontSize(), kMark, 0,
                                              0.1f * ImGui::GetFontSize());
}

}  // namespace hazer::app
