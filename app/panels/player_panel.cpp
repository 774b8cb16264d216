#include "app/panels/player_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/moment.h"

namespace hazer::app {
namespace {

double secondsOf(Playback::Time time) {
    return std::chrono::duration<double>(time).count();
}

/// A slider over what can be gone to in a moment. While the index is being built, it grows.
void drawScrubber(Playback& playback) {
    const Playback::Time end = std::max(playback.scrubEnd(), playback.time());
    const double least = 0.0;
    const double most = secondsOf(end);
    double at = secondsOf(playback.time());
    ImGui::SetNextItemWidth(-1.0f);
    const std::string shown = fmt::format("{} of {}{}", momentText(playback.time()), momentText(end),
                                          playback.duration() ? "" : " ...");
    if (ImGui::SliderScalar("##time", ImGuiDataType_Double, &at, &least, &most, shown.c_str())) {
        playback.goTo(std::chrono::duration_cast<Playback::Time>(std::chrono::duration<double>(at)));
    }
    if (ImGui::IsItemHovered() && !playback.duration()) {
        ImGui::SetTooltip("the rest of the recording is still being read");
    }
}

void drawPlayer(Playback& playback) {
    ImGui::TextUnformatted(playback.name().c_str());
    if (ImGui::Button(playback.isPlaying ? "Pause" : "Play")) playback.isPlaying = !playback.isPlaying;
    ImGui::SameLine();
    if (ImGui::Button("To start")) playback.goTo(Playback::Time(0));
    ImGui::SameLine();
    ImGui::Checkbox("Loop", &playback.loops);
    drawScrubber(playback);
}

}  // namespace

void drawPlayers(Session& session) {
    for (const auto& playback : session.playbacks()) {
        ImGui::PushID(playback.get());
        drawPlayer(*playback);
        ImGui::PopID();
    }
}

}  // namespace hazer::app
