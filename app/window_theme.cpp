#include "app/window_theme.h"

#include <imgui.h>

#include <array>
#include <filesystem>

namespace hazer::app {
namespace {

constexpr float kFontSizePx = 15.0f;

/// Where systems keep a plain sans-serif font. ImGui's own font, which is made for one size, comes last.
constexpr std::array kFontFiles{
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
    "/System/Library/Fonts/Supplemental/Arial.ttf",
    "C:/Windows/Fonts/segoeui.ttf",
};

void loadFont(float sizePx) {
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    fonts.Clear();
    for (const char* file : kFontFiles) {
        std::error_code none;
        if (std::filesystem::exists(file, none) && fonts.AddFontFromFileTTF(file, sizePx) != nullptr) return;
    }
    ImFontConfig config;
    config.SizePixels = sizePx;
    fonts.AddFontDefault(&config);
}

/// Grey, so that the panels do not tint what the eye makes of the light; amber for what a hand has touched.
void setColors(ImGuiStyle& style) {
    const ImVec4 panel{0.09f, 0.09f, 0.10f, 0.90f};
    const ImVec4 field{0.20f, 0.20f, 0.21f, 1.0f};
    const ImVec4 fieldHovered{0.27f, 0.27f, 0.29f, 1.0f};
    const ImVec4 fieldActive{0.33f, 0.33f, 0.35f, 1.0f};
    // Slider handles are see-through: the value is written behind them.
    const ImVec4 handle{0.75f, 0.75f, 0.78f, 0.40f};
    const ImVec4 handleActive{0.90f, 0.90f, 0.92f, 0.60f};
    ImGui::StyleColorsDark(&style);
    style.Colors[ImGuiCol_WindowBg] = panel;
    style.Colors[ImGuiCol_PopupBg] = {panel.x, panel.y, panel.z, 0.97f};
    for (const int which : {ImGuiCol_FrameBg, ImGuiCol_Button, ImGuiCol_Header, ImGuiCol_TitleBgActive}) {
        style.Colors[which] = field;
    }
    for (const int which : {ImGuiCol_FrameBgHovered, ImGuiCol_ButtonHovered, ImGuiCol_HeaderHovered}) {
        style.Colors[which] = fieldHovered;
    }
    for (const int which : {ImGuiCol_FrameBgActive, ImGuiCol_ButtonActive, ImGuiCol_HeaderActive}) {
        style.Colors[which] = fieldActive;
    }
    style.Colors[ImGuiCol_SliderGrab] = handle;
    const ImVec4 mark{0.85f, 0.85f, 0.87f, 1.0f};
    style.Colors[ImGuiCol_CheckMark] = mark;
    style.Colors[ImGuiCol_PlotLines] = mark;
    style.Colors[ImGuiCol_SliderGrabActive] = handleActive;
}

}  // namespace

void applyTheme(float contentScale) {
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    setColors(style);
    style.WindowRounding = 0.0f;
    style.WindowBorderSize = 0.0f;
    style.FrameRounding = 3.0f;
    style.GrabRounding = 3.0f;
    style.ItemSpacing = {6.0f, 5.0f};
    style.ScaleAllSizes(contentScale);
    loadFont(kFontSizePx * contentScale);
}

}  // namespace hazer::app
