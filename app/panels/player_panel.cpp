#include "app/panels/player_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/moment.h"
#include "app/monitor.h"

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

/// What the time code says, where one can come; a recording that follows it is not to be moved by hand.
void drawTimeCode(Playback& playback, const Inputs& inputs) {
    if (!inputs.hearsTimeCode()) return;
    ImGui::Checkbox("Follow time code", &playback.followsTimeCode);
    if (!playback.followsTimeCode) return;
    const auto code = inputs.artNet().timeCode;
    if (!code) return ImGui::TextDisabled("waits for a time code");
    ImGui::TextDisabled("%s, %s", timeCodeText(code->code).c_str(),
                        playback.isCodeRunning() ? "runs" : "stands");
}

void drawPlayer(Playback& playback, const Inputs& inputs) {
    ImGui::TextUnformatted(playback.name().c_str());
    const bool isLed = playback.followsTimeCode && inputs.hearsTimeCode();
    ImGui::BeginDisabled(isLed);
    if (ImGui::Button(playback.isPlaying ? "Pause" : "Play")) playback.isPlaying = !playback.isPlaying;
    ImGui::SameLine();
    if (ImGui::Button("To start")) playback.goTo(Playback::Time(0));
    ImGui::SameLine();
    ImGui::Checkbox("Loop", &playback.loops);
    ImGui::EndDisabled();
    drawTimeCode(playback, inputs);
    ImGui::BeginDisabled(isLed);
    drawScrubber(playback);
    ImGui::EndDisabled();
}

}  // namespace

void drawPlayers(Session& session) {
    for (const auto& playback : session.playbacks()) {
        ImGui::PushID(playback.get());
        drawPlayer(*playback, session.inputs());
        ImGui::PopID();
    }
}

}  // namespace hazer::app
