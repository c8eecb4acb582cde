// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>
#include <imgui.h>

#include <functional>
#include <string>

namespace sl {

/// Dear ImGui without a window or a driver: a screen large enough that nothing is clipped, and a mouse that
/// tests move.
class ImguiTest : public testing::Test {
  protected:
    ImguiTest() {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = ImVec2(1000, 20000);
        io.DeltaTime = 1.0f / 60.0f;
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
        io.ClipboardUserData = &text_;
        io.SetClipboardTextFn = [](void* user, const char* text) { *static_cast<std::string*>(user) = text; };
    }
    ~ImguiTest() override { ImGui::DestroyContext(); }

    /// One frame with one window that `draw` fills.
    static void frame(const std::function<void()>& draw) {
        ImGui::NewFrame();
        ImGui::SetNextWindowPos(ImVec2(0, 0));
        ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
        ImGui::Begin("window", nullptr, ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove);
        draw();
        ImGui::End();
        ImGui::Render();
    }

    /// All text that a frame shows; tree nodes count as open.
    std::string text_of(const std::function<void()>& draw) {
        frame([&] {
            ImGui::LogToClipboard();
            draw();
            ImGui::LogFinish();
        });
        return text_;
    }

    static void mouse(ImVec2 place, bool down) {
        ImGui::GetIO().MousePos = place;
        ImGui::GetIO().MouseDown[0] = down;
    }
    static void click(ImVec2 place, const std::function<void()>& draw) {
        for (const bool down : {false, true, false}) {
            mouse(place, down);
            frame(draw);
        }
    }

  private:
    std::string text_;
};

}  // namespace sl
