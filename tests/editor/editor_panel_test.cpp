// SPDX-License-Identifier: MIT
#include "editor/editor_panel.h"

#include <gmock/gmock.h>

#include "editor/entity_edits.h"
#include "engine/core/field_random.h"
#include "tests/editor/panel_test.h"

namespace sl {
namespace {

using testing::HasSubstr;

const std::array<ImVec2, 3> screens{ImVec2(640, 360), ImVec2(1280, 720), ImVec2(3840, 2160)};

class EditorPanelTest : public PanelTest {
  protected:
    void draw_panel() {
        ImGui::NewFrame();
        editor_panel(app_, report_, state_);
        ImGui::Render();
    }
    /// A key as the window would report it, with Ctrl and Shift held where asked for.
    void press(ImGuiKey key, bool shift = false) {
        ImGuiIO& io = ImGui::GetIO();
        io.KeyMap[key] = key;
        io.KeyCtrl = true;
        io.KeyShift = shift;
        for (const bool down : {true, false}) {
            io.KeysDown[key] = down;
            draw_panel();
        }
        io.KeyCtrl = io.KeyShift = false;
    }
};

TEST_F(EditorPanelTest, EveryTabIsDrawnWithEveryComponentOnEveryScreen) {
    const Entity all = app_.world.create(Name{"all"}, WorldTransform{});
    select(all);
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        for (const ComponentType& type : app_.registry().types()) {
            if (!type.has(app_.world, all)) type.add_default(app_.world, all);
            RandomFields random(seed);
            type.visit(app_.world, all, random);
        }
        for (const ImVec2& screen : screens) {
            ImGui::GetIO().DisplaySize = screen;
            state_.scale = screen.y / 720.0f;
            draw_panel();
            draw_panel();
            frame([&] { light_tab(scene(), report_, state_.light); });
            frame([&] { scene_tab(scene(), state_.scene); });
            frame([&] { picture_tab(scene(), report_, state_.picture); });
            frame([&] { frame_tab(report_, app_.schedule, state_.frame); });
        }
    }
    EXPECT_TRUE(state_.history.done().empty());
}

TEST_F(EditorPanelTest, ControlZUndoesAndControlYAndControlShiftZDoItAgain) {
    draw_panel();
    remove_component(scene(), lamp_, *app_.registry().find("spot_light"));
    press(ImGuiKey_Z);
    EXPECT_TRUE(app_.world.has<SpotLight>(lamp_));
    press(ImGuiKey_Z, true);
    EXPECT_FALSE(app_.world.has<SpotLight>(lamp_));
    press(ImGuiKey_Z);
    press(ImGuiKey_Y);
    EXPECT_FALSE(app_.world.has<SpotLight>(lamp_));
}

TEST_F(EditorPanelTest, TheFrameTabShowsPassesSystemsAndMemory) {
    const auto draw = [&] {
        open({"Systems", "Frame graph"});
        frame_tab(report_, app_.schedule, state_.frame);
    };
    const std::string text = shown(draw);
    for (const char* word : {"gbuffer", "of which GI 0.75 ms", "3400", "77", "40.0 MiB", "derive: world_transform", "rsm_flux 256x256x1"}) {
        EXPECT_THAT(text, HasSubstr(word));
    }
}

TEST_F(EditorPanelTest, LinesOverThePictureShowTheChosenLight) {
    const auto lines = [&](Entity entity) {
        select(entity);
        draw_panel();
        return ImGui::GetBackgroundDrawList()->VtxBuffer.Size;
    };
    const Entity sun = app_.world.create(Name{"sun"}, DirectionalLight{}, WorldTransform{});
    const Entity bulb = app_.world.create(Name{"bulb"}, PointLight{}, WorldTransform{.origin = {0, 0, -4}});
    EXPECT_EQ(lines(camera_), 0);
    for (const Entity light : {lamp_, sun, bulb}) EXPECT_GT(lines(light), 0);
    app_.world.get<WorldTransform>(bulb).origin.z = 4.0;
    EXPECT_EQ(lines(bulb), 0) << "behind the camera";
    app_.world.get<WorldTransform>(lamp_).linear = mat3(0.0f);
    lines(lamp_);
    for (const ImDrawVert& vertex : ImGui::GetBackgroundDrawList()->VtxBuffer) EXPECT_TRUE(std::isfinite(vertex.pos.x + vertex.pos.y));
}

}  // namespace
}  // namespace sl
