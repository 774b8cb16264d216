#include "app/panels/help_panel.h"

#include <imgui.h>

#include <array>

namespace hazer::app {
namespace {

struct HelpLine {
    const char* input;
    const char* effect;
};

constexpr std::array kHelpLines{
    HelpLine{"left drag", "orbit"},
    HelpLine{"right or middle drag", "pan"},
    HelpLine{"wheel", "nearer, farther"},
    HelpLine{"click on a lamp", "select it"},
    HelpLine{"F", "frame the stage"},
    HelpLine{"1 .. 9", "the show's cameras"},
    HelpLine{"Tab", "panels on and off"},
    HelpLine{"H", "this sheet"},
    HelpLine{"Ctrl + click on a slider", "type a value"},
    HelpLine{"x beside a fader", "release it to DMX"},
};

}  // namespace

void drawHelpPanel(bool& isOpen) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * size.x, 0.5f * size.y}, ImGuiCond_Always, {0.5f, 0.5f});
    constexpr float kOpaque = 1.0f;  // it may lie on the other panels' text
    ImGui::SetNextWindowBgAlpha(kOpaque);
    if (ImGui::Begin("Help", &isOpen, ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_AlwaysAutoResize) &&
        ImGui::BeginTable("help", 2, ImGuiTableFlags_SizingFixedFit)) {
        for (const HelpLine& line : kHelpLines) {
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(line.input);
            ImGui::TableNextColumn();
            ImGui::TextDisabled("%s", line.effect);
        }
        ImGui::EndTable();
    }
    ImGui::End();
}

}  // namespace hazer::app
