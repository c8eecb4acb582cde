// SPDX-License-Identifier: MIT
#include "editor/picture_tab.h"

#include <imgui.h>

#include "editor/capture_command.h"
#include "editor/shell_words.h"

namespace sl {

namespace {

void copy_settings(const EditedScene& scene, const FrameReport& report, PictureTab& state) {
    try {
        const uvec2 size = report.drawn ? report.size : uvec2(640, 360);
        state.command = shell_line(capture_command(scene.world, scene.registry, size));
        ImGui::SetClipboardText(state.command.c_str());
        state.copied = {"Copied:"};
    } catch (const std::exception& error) {
        state.command.clear();
        state.copied = {error.what(), true};
    }
}

}  // namespace

void picture_tab(const EditedScene& scene, const FrameReport& report, PictureTab& state) {
    ImGui::BeginDisabled(!report.drawn);
    if (ImGui::Button("Save PNG")) state.wish = PictureFormat::png;
    ImGui::SameLine();
    if (ImGui::Button("Save EXR with layers")) state.wish = PictureFormat::exr;
    ImGui::EndDisabled();
    ImGui::TextWrapped("Pictures go into the folder out. The PNG is what is shown; the EXR holds radiance, direct light, irradiance, albedo, normals and depth.");
    show(state.saved);
    ImGui::Separator();
    if (ImGui::Button("Copy settings as a command line")) copy_settings(scene, report, state);
    ImGui::TextWrapped("For a capture of this view with these GI and camera settings; what else was changed has to be saved with the scene first.");
    show(state.copied);
    ImGui::TextWrapped("%s", state.command.c_str());
}

}  // namespace sl
