// SPDX-License-Identifier: MIT
#include "editor/imgui_layer.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "editor/imgui_navigation.h"
#include "editor/imgui_taps.h"

namespace sl {

namespace {

constexpr float font_pixels = 13.0f;  // ImGui's own font is drawn for this size
constexpr float large_screen = 1080.0f;  // pixels high; twice as high, texts are twice as large

/// By whole numbers, which keep the pixels of the font sharp.
float enlargement(float screen_height, float content_scale) {
    return std::max(1.0f, std::floor(screen_height / (large_screen * content_scale)));
}

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
    ImGui_ImplOpenGL3_Init("#version 450 core");
}

ImguiLayer::~ImguiLayer() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

float ImguiLayer::scale() const { return scale_ * ImGui::GetIO().FontGlobalScale; }

void ImguiLayer::begin(Input& input, bool navigate) {
    ImGuiIO& io = ImGui::GetIO();
    // A captured pointer has no place on the screen and must not hover over widgets.
    if (input.mouse_captured) {
        io.ConfigFlags |= ImGuiConfigFlags_NoMouse;
    } else {
        io.ConfigFlags &= ~ImGuiConfigFlags_NoMouse;
    }
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    io.FontGlobalScale = enlargement(io.DisplaySize.y, scale_);
    keep_taps(input);
    navigate_widgets(navigate, input);
    ImGui::NewFrame();
    if (io.WantCaptureKeyboard) input.ignore_keys();
    if (io.WantCaptureMouse) input.ignore_mouse();
}

void ImguiLayer::draw() {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

bool ImguiLayer::has_keyboard() {
    return ImGui::GetIO().WantTextInput;
}

bool ImguiLayer::has_active_widget() {
    return ImGui::IsAnyItemActive();
}

void ImguiLayer::skip() {
    ImGui::EndFrame();
}

}  // namespace sl
