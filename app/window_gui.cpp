#include "app/window_gui.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "app/window_theme.h"
#include "render/error.h"

namespace hazer::app {
namespace {

constexpr const char* kGlslVersion = "#version 410 core";

void startBackends(GLFWwindow* window) {
    if (!ImGui_ImplGlfw_InitForOpenGL(window, true) || !ImGui_ImplOpenGL3_Init(kGlslVersion)) {
        throw render::NoGlError("the panels cannot be drawn with this OpenGL; update the graphics driver");
    }
}

}  // namespace

WindowGui::WindowGui(Window& window) : window_(window), contentScale_(window.contentScale()) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // the layout is fixed: there is nothing to remember
    applyTheme(contentScale_);
    startBackends(window.glfw());
}

WindowGui::~WindowGui() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void WindowGui::begin() {
    if (window_.contentScale() != contentScale_) {
        contentScale_ = window_.contentScale();
        applyTheme(contentScale_);
        ImGui_ImplOpenGL3_DestroyDeviceObjects();  // the next frame makes them with the new font
    }
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

void WindowGui::draw() {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace hazer::app
