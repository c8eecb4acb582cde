// SPDX-License-Identifier: MIT
#include "editor/imgui_layer.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace sl {

namespace {

constexpr float font_pixels = 13.0f;  // ImGui's own font is drawn for this size

}  // namespace

ImguiLayer::ImguiLayer(const Window& window) : scale_(window.content_scale()) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    ImFontConfig font;
    font.SizePixels = std::round(font_pixels * scale_);
    io.Fonts->AddFontDefault(&font);
    ImGui::StyleColorsDark();
    ImGui::GetStyle().WindowRounding = 4.0f;
    ImGui::GetStyle().ScaleAllSizes(scale_);
    // Chains the window's own callbacks, which are there already.
    ImGui_ImplGlfw_InitForOpenGL(window.native(), true);
    taps_.emplace(window.native());
    ImGui_ImplOpenGL3_Init("#version 450 core");
}

ImguiLayer::~ImguiLayer() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void ImguiLayer::begin(Input& input) {
    ImGuiIO& io = ImGui::GetIO();
    // A captured pointer has no place on the screen and must not hover over widgets.
    if (input.mouse_captured) {
        io.ConfigFlags |= ImGuiConfigFlags_NoMouse;
    } else {
        io.ConfigFlags &= ~ImGuiConfigFlags_NoMouse;
    }
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    taps_->hold();
    ImGui::NewFrame();
    if (io.WantCaptureKeyboard) input.ignore_keys();
    if (io.WantCaptureMouse) input.ignore_mouse();
}

void ImguiLayer::draw() {
    ImGui::Render();
    taps_->release();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

bool ImguiLayer::has_keyboard() {
    return ImGui::GetIO().WantTextInput;
}

void ImguiLayer::skip() {
    ImGui::EndFrame();
    taps_->release();
}

}  // namespace sl
