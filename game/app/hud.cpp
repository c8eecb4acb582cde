// SPDX-License-Identifier: MIT
#include "game/app/hud.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "engine/core/field_list.h"
#include "engine/core/key_names.h"
#include "game/app/hud_blocks.h"
#include "game/app/hud_crystals.h"
#include "game/block_tool.h"
#include "game/crystals/crystals.h"
#include "game/menu/keys_text.h"
#include "game/menu/panel_text.h"
#include "game/notice.h"
#include "game/saved_world.h"
#include "game/session.h"
#include "game/voxel_content.h"

namespace sl {

namespace {

constexpr ImU32 plain = IM_COL32(255, 255, 255, 255);
constexpr ImU32 faint = IM_COL32(255, 255, 255, 140);
constexpr ImU32 alarming = IM_COL32(255, 150, 90, 255);

/// Lines on a dark ground, broken where the screen ends, with their pivot (0 to 1 of their own size) at a point of the screen. Not an ImGui
/// window: those learn the size of what is in them a frame too late, which shows where a frame takes a
/// second.
class TextBox {
  public:
    void line(const std::string& text, ImU32 colour = plain) { lines_.push_back({text, colour}); }
    bool empty() const { return lines_.empty(); }

    /// With the ground around them.
    ImVec2 size() const {
        ImVec2 inner(0, 0);
        for (const auto& [text, colour] : lines_) {
            const ImVec2 extent = extent_of(text);
            inner = ImVec2(std::max(inner.x, extent.x), inner.y + extent.y);
        }
        return ImVec2(inner.x + 2 * gap(), inner.y + 2 * gap());
    }

    void draw(ImVec2 point, ImVec2 pivot, int darkness = 115) const {
        const ImVec2 outer = size();
        ImVec2 at(std::round(point.x - pivot.x * outer.x), std::round(point.y - pivot.y * outer.y));
        ImDrawList& list = *ImGui::GetBackgroundDrawList();
        list.AddRectFilled(at, ImVec2(at.x + outer.x, at.y + outer.y), IM_COL32(0, 0, 0, darkness),
                           gap() * 0.5f);
        at = ImVec2(at.x + gap(), at.y + gap());
        for (const auto& [text, colour] : lines_) {
            list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), at, colour, text.c_str(), nullptr, widest());
            at.y += extent_of(text).y;
        }
    }

  private:
    static float gap() { return ImGui::GetFontSize() * 0.5f; }
    static float widest() { return std::max(ImGui::GetMainViewport()->Size.x - 4.0f * gap(), 1.0f); }
    static ImVec2 extent_of(const std::string& text) { return ImGui::CalcTextSize(text.c_str(), nullptr, false, widest()); }

    struct Line {
        std::string text;
        ImU32 colour;
    };
    std::vector<Line> lines_;
};

/// "rsm_grid: paper-artefact", "off", or "none" where the camera has no settings.
std::string method_text(World& world) {
    const Entity camera = active_camera(world);
    const auto* gi = camera ? world.find<GiSettings>(camera) : nullptr;
    if (gi == nullptr) return "none";
    std::string text(gi->method.name());
    for (const FieldRow& row : list_fields(*gi)) {
        if (row.name == "preset") text += ": " + row.value;
    }
    return text;
}

TextBox status(App& app, const HudInput& input) {
    TextBox box;
    const double ms = input.frame_ms;
    const std::string keys = fmt::format("{} panel  {} help", key_label(input.keys[Action::panel]), key_label(input.keys[Action::help]));
    // Who plays looks for crystals; the panel is for figures.
    if (const auto* search = app.world.find_resource<CrystalSearch>(); search != nullptr && search->all > 0 && !input.panel) {
        box.line(fmt::format("{:.0f} fps", ms > 0.0 ? 1000.0 / ms : 0.0), faint);
        if (!input.mouse_captured) box.line("click to look round", faint);
        box.line(keys, faint);
        return box;
    }
    box.line(fmt::format("GI {}", method_text(app.world)));
    box.line(fmt::format("frame {:.1f} ms  {:.0f} fps", ms, ms > 0.0 ? 1000.0 / ms : 0.0));
    box.line(fmt::format("GI    {:.2f} ms", input.gi_ms));
    box.line(fmt::format("triangles {} drawn, {} culled", input.frame.triangles_drawn,
                         input.frame.triangles_culled));
    if (input.frame.drawn && input.frame.images.gi_progress < 1.0f) {
        box.line(fmt::format("GI {:.1f} % done", 100.0f * input.frame.images.gi_progress));
    }
    if (input.frame.drawn && input.frame.images.gi_error) box.line(fmt::format("GI noise {:.1f} %", 100.0f * *input.frame.images.gi_error));
    if (app.world.resource<VoxelStats>().chunks > 0) {
        box.line(fmt::format("block {}", block_info(app.world.resource<BlockTool>().held).name));
    }
    const char* click = input.mouse_captured ? "" : input.click_measures ? "click to measure light  " : "click to look round  ";
    box.line(click + keys, faint);
    return box;
}

void crosshair(ImVec2 centre) {
    const float arm = ImGui::GetFontSize() * 0.55f;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    for (const auto& [colour, width] :
         {std::pair(IM_COL32(0, 0, 0, 160), 3.0f), std::pair(IM_COL32(255, 255, 255, 210), 1.0f)}) {
        list.AddLine(ImVec2(centre.x - arm, centre.y), ImVec2(centre.x + arm, centre.y), colour, width);
        list.AddLine(ImVec2(centre.x, centre.y - arm), ImVec2(centre.x, centre.y + arm), colour, width);
    }
}

void message(const std::string& text, ImVec2 point, ImU32 colour, int darkness = 115) {
    TextBox box;
    box.line(text, colour);
    box.draw(point, ImVec2(0.5f, 0.5f), darkness);
}

std::string reading_text(const ModelBeingRead& model) {
    const std::string name = model.file.filename().string();
    if (model.pictures == 0) return fmt::format("reading {}, {:.0f} s", name, model.seconds);
    std::string text = fmt::format("reading {}: {} of {} pictures", name, model.decoded, model.pictures);
    if (model.decoded > 0) text += fmt::format(", about {:.0f} s left", std::ceil(model.seconds * static_cast<double>(model.pictures - model.decoded) / static_cast<double>(model.decoded)));
    return text;
}

/// Models on their way, and those that cannot be shown, in the lower left corner.
void draw_models(const ModelLibrary& library, const HudInput& input, ImVec2 corner) {
    TextBox box;
    for (const ModelBeingRead& model : input.being_read) box.line(reading_text(model));
    for (const std::string& fault : library.faults()) box.line(fault, alarming);
    if (!box.empty()) box.draw(corner, ImVec2(0, 1), 190);
}

/// The keys, and beside them how the panel works, where the screen is wide enough for both.
void draw_help(const KeyBindings& bindings) {
    const ImGuiViewport& screen = *ImGui::GetMainViewport();
    const ImVec2 centre = screen.GetCenter();
    TextBox keys, panel;
    keys.line(keys_text(bindings));
    panel.line(panel_text(bindings));
    const float left = keys.size().x, right = panel.size().x, gap = ImGui::GetFontSize();
    if (left + gap + right > screen.Size.x) return keys.draw(centre, ImVec2(0.5f, 0.5f), 190);
    const float seam = centre.x + 0.5f * (left - right);
    keys.draw(ImVec2(seam - 0.5f * gap, centre.y), ImVec2(1.0f, 0.5f), 190);
    panel.draw(ImVec2(seam + 0.5f * gap, centre.y), ImVec2(0.0f, 0.5f), 190);
}

}  // namespace

void draw_hud(App& app, const HudInput& input) {
    const ImGuiViewport& screen = *ImGui::GetMainViewport();
    const float gap = ImGui::GetFontSize() * 0.6f;
    const ImVec2 centre = screen.GetCenter();
    if (!input.help) status(app, input).draw(ImVec2(gap, gap), ImVec2(0, 0));
    if (!input.failure.empty()) {
        message(input.failure, centre, alarming);
    } else if (input.placeholder) {
        message(input.being_read.empty() ? "getting ready" : reading_text(input.being_read.front()), centre, plain);
    } else if (!input.frame.drawn) {
        message(
            "This scene has no active camera, so there is nothing to see.\n"
            "Press F1 and tick \"active\" on a camera, or add one to an entity.",
            centre, alarming);
    } else {
        draw_block_outline(app.world);
        crosshair(centre);
        draw_hotbar(app.world);
        draw_crystal_search(app.world);
    }
    const ImVec2 lower_left(gap, screen.Size.y - gap);
    if (!input.placeholder) draw_models(app.world.resource<ModelLibrary>(), input, lower_left);
    if (!input.shader_errors.empty()) {
        TextBox box;
        box.line("A shader is broken; the last good one is in use.", alarming);
        for (const std::string& error : input.shader_errors) box.line(error, alarming);
        box.draw(lower_left, ImVec2(0, 1), 190);
    }
    if (const auto* saved = app.world.find_resource<SavedWorld>(); saved != nullptr && !saved->file->status().problem.empty()) {
        const WorldFile::Status status = saved->file->status();
        message(fmt::format("{} ({} changes wait)", status.problem, status.waiting), ImVec2(centre.x, screen.Size.y * 0.12f), alarming, 190);
    }
    if (const auto& notice = app.world.resource<Notice>(); notice.seconds_left > 0.0) {
        message(notice.text, ImVec2(centre.x, screen.Size.y * 0.75f), plain);
    }
    if (input.help) draw_help(input.keys);
}

}  // namespace sl
