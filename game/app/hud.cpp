// SPDX-License-Identifier: MIT
#include "game/app/hud.h"

#include <imgui.h>

#include <algorithm>

#include "engine/core/field_list.h"
#include "game/block_tool.h"
#include "game/notice.h"
#include "game/session.h"
#include "game/voxel_content.h"

namespace sl {

namespace {

constexpr ImGuiWindowFlags untouchable = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                                         ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing |
                                         ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_AlwaysAutoResize;
const ImVec4 warning_colour(1.0f, 0.55f, 0.35f, 1.0f);

constexpr const char* keys_text =
    "click         capture the mouse, then:\n"
    "  left        break a block\n"
    "  right       place a block\n"
    "  middle      take the kind of block\n"
    "1 ... 9       choose a block\n"
    "W A S D       fly;  E up, Q down\n"
    "Shift         faster;  wheel: speed\n"
    "G             next GI method\n"
    "O             GI off and on\n"
    "[ ] or < >    sun round\n"
    "up, down      sun higher, lower\n"
    "+ -           brighter, darker\n"
    "F1            editor panel\n"
    "F11           fullscreen\n"
    "F12           capture into out/\n"
    "Escape        free the mouse\n"
    "Ctrl+Q        quit";

/// A window of text with its pivot (0 to 1 of its own size) at a point of the screen.
template <class Draw>
void text_window(const char* name, ImVec2 point, ImVec2 pivot, Draw draw) {
    ImGui::SetNextWindowPos(point, ImGuiCond_Always, pivot);
    ImGui::SetNextWindowBgAlpha(0.45f);
    if (ImGui::Begin(name, nullptr, untouchable)) draw();
    ImGui::End();
}

/// "rsm_grid: paper-artefact", "off", or "none" where the camera has no settings.
std::string method_text(World& world) {
    const Entity camera = active_camera(world);
    const auto* gi = camera ? world.find<GiSettings>(camera) : nullptr;
    if (gi == nullptr) return "none";
    std::string text(gi_method_name(gi->method));
    for (const FieldRow& row : list_fields(*gi)) {
        if (row.name == "preset") text += ": " + row.value;
    }
    return text;
}

void status_text(App& app, const HudInput& input) {
    const double ms = input.frame_ms;
    ImGui::Text("GI %s", method_text(app.world).c_str());
    ImGui::Text("frame %.1f ms  %.0f fps", ms, ms > 0.0 ? 1000.0 / ms : 0.0);
    ImGui::Text("GI    %.2f ms", input.gi_ms);
    ImGui::Text("triangles %llu drawn, %llu culled", static_cast<unsigned long long>(input.frame.triangles_drawn),
                static_cast<unsigned long long>(input.frame.triangles_culled));
    if (input.frame.drawn && input.frame.images.gi_progress < 1.0f) {
        ImGui::Text("GI %.0f %% done", 100.0 * double{input.frame.images.gi_progress});
    }
    if (app.world.find_resource<VoxelStats>() != nullptr && app.world.resource<VoxelStats>().chunks > 0) {
        const std::string_view held = block_info(app.world.resource<BlockTool>().held).name;
        ImGui::Text("block %.*s", static_cast<int>(held.size()), held.data());
    }
    ImGui::TextDisabled(input.mouse_captured ? "F1 panel  H help" : "click to look round  F1 panel  H help");
}

void crosshair(ImVec2 centre) {
    const float arm = ImGui::GetFontSize() * 0.55f;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    for (const auto& [colour, width] : {std::pair(IM_COL32(0, 0, 0, 160), 3.0f), std::pair(IM_COL32(255, 255, 255, 210), 1.0f)}) {
        list.AddLine(ImVec2(centre.x - arm, centre.y), ImVec2(centre.x + arm, centre.y), colour, width);
        list.AddLine(ImVec2(centre.x, centre.y - arm), ImVec2(centre.x, centre.y + arm), colour, width);
    }
}

void warn(const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, warning_colour);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
}

}  // namespace

double gi_milliseconds(std::span<const std::pair<std::string, double>> passes) {
    double sum = 0.0;
    for (const auto& [name, milliseconds] : passes) {
        if (name.starts_with("rsm") || name.starts_with("irradiance")) sum += milliseconds;
    }
    return sum;
}

void draw_hud(App& app, const HudInput& input) {
    const ImGuiViewport& screen = *ImGui::GetMainViewport();
    const float gap = ImGui::GetFontSize() * 0.6f;
    const ImVec2 centre = screen.GetCenter();
    text_window("status", ImVec2(gap, gap), ImVec2(0, 0), [&] { status_text(app, input); });
    if (!input.failure.empty()) {
        text_window("failure", centre, ImVec2(0.5f, 0.5f), [&] { warn(input.failure); });
    } else if (!input.frame.drawn) {
        text_window("failure", centre, ImVec2(0.5f, 0.5f), [] {
            warn("This scene has no active camera, so there is nothing to see.\n"
                 "Press F1 and tick \"active\" on a camera, or add one to an entity.");
        });
    } else {
        crosshair(centre);
    }
    if (!input.shader_errors.empty()) {
        text_window("shaders", ImVec2(gap, screen.Size.y - gap), ImVec2(0, 1), [&] {
            warn("A shader is broken; the last good one is in use.");
            for (const std::string& error : input.shader_errors) warn(error);
        });
    }
    if (const auto& notice = app.world.resource<Notice>(); notice.seconds_left > 0.0) {
        text_window("notice", ImVec2(centre.x, screen.Size.y * 0.8f), ImVec2(0.5f, 0.5f),
                    [&] { ImGui::TextUnformatted(notice.text.c_str()); });
    }
    if (input.help) text_window("help", centre, ImVec2(0.5f, 0.5f), [] { ImGui::TextUnformatted(keys_text); });
}

}  // namespace sl
