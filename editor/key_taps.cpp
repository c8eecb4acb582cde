// SPDX-License-Identifier: MIT
#include "editor/key_taps.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

namespace sl {

namespace {

void update_modifiers() {
    ImGuiIO& io = ImGui::GetIO();
    io.KeyCtrl = io.KeysDown[GLFW_KEY_LEFT_CONTROL] || io.KeysDown[GLFW_KEY_RIGHT_CONTROL];
    io.KeyShift = io.KeysDown[GLFW_KEY_LEFT_SHIFT] || io.KeysDown[GLFW_KEY_RIGHT_SHIFT];
}

}  // namespace

KeyTaps::KeyTaps(GLFWwindow* window) {
    static_assert(key_count == IM_ARRAYSIZE(ImGuiIO::KeysDown));
    ImGui::GetIO().UserData = this;
    glfwSetKeyCallback(window, &on_key);
}

void KeyTaps::on_key(GLFWwindow* window, int key, int scancode, int action, int modifiers) {
    // It knows which key the keyboard's layout makes of this one, and so which is down now.
    ImGui_ImplGlfw_KeyCallback(window, key, scancode, action, modifiers);
    const ImGuiIO& io = ImGui::GetIO();
    auto& taps = *static_cast<KeyTaps*>(io.UserData);
    for (std::size_t i = 0; i < key_count; ++i) taps.pressed_[i] = taps.pressed_[i] || io.KeysDown[i];
}

void KeyTaps::hold() {
    ImGuiIO& io = ImGui::GetIO();
    for (std::size_t i = 0; i < key_count; ++i) {
        held_[i] = pressed_[i] && !io.KeysDown[i];
        io.KeysDown[i] = io.KeysDown[i] || held_[i];
    }
    pressed_.reset();
    if (held_.any()) update_modifiers();
}

void KeyTaps::release() {
    if (held_.none()) return;
    ImGuiIO& io = ImGui::GetIO();
    for (std::size_t i = 0; i < key_count; ++i) io.KeysDown[i] = io.KeysDown[i] && !held_[i];
    held_.reset();
    update_modifiers();
}

}  // namespace sl
