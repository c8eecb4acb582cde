// SPDX-License-Identifier: MIT
#pragma once

#include "editor/editor_panel.h"
#include "engine/ecs/components.h"
#include "tests/editor/imgui_test.h"

namespace sl {

/// A scene with every kind of light, and what a renderer would say of a frame of it.
class PanelTest : public ImguiTest {
  protected:
    App app_;
    EditorState state_{.open = true};
    FrameReport report_{.drawn = true,
                        .size = {640, 360},
                        .passes = {{.name = "gbuffer", .reads = "", .writes = "albedo 640x360, depth 640x360", .draws = 12, .triangles = 3400, .milliseconds = 1.5},
                                   {.name = "rsm_0", .indirect = true, .reads = "", .writes = "rsm_flux 256x256x1", .draws = 8, .triangles = 1200}},
                        .times = {{"gbuffer", "", 1.5}, {"rsm", "gi", 0.75}},
                        .triangles_drawn = 3400,
                        .triangles_culled = 77,
                        .mesh_bytes = 3u << 20,
                        .texture_bytes = 40u << 20,
                        .noise = 0.07f};
    Entity camera_ = app_.world.create(Name{"eye"}, Camera{}, Transform{}, WorldTransform{}, GiSettings{RsmGrid{}});
    Entity lamp_ = app_.world.create(Name{"lamp"}, SpotLight{}, Transform{}, WorldTransform{});

    PanelTest() {
        app_.world.create(Name{"sunlight"}, SunAngles{}, DirectionalLight{}, Transform{});
        app_.world.create(Name{"heaven"}, SkyLight{});
        app_.world.create(Name{"box"}, Shape{}, Material{}, Transform{});
    }

    EditedScene scene() { return {app_.world, app_.registry(), state_.history}; }
    void select(Entity entity) { state_.scene.selected = state_.history.keys().key_of(entity); }
    std::string shown(const std::function<void()>& draw) {
        frame(draw);
        return text_of(draw);
    }
    static void open(std::initializer_list<const char*> headers) {
        for (const char* header : headers) ImGui::GetStateStorage()->SetInt(ImGui::GetID(header), 1);
    }
};

}  // namespace sl
