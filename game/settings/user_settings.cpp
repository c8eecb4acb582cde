// SPDX-License-Identifier: MIT
#include "game/settings/user_settings.h"

#include <vector>

#include "engine/ecs/components/gi_settings.h"

namespace sl {

namespace {

constexpr std::array<std::string_view, 4> preset_names{"usual", "low", "medium", "high"};

std::span<const std::string_view> method_names() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all{"as_the_scene_has_it"};
        all.insert(all.end(), gi_method_names().begin(), gi_method_names().end());
        return all;
    }();
    return names;
}

}  // namespace

void visit_fields(FieldVisitor& visit, ControlSettings& controls) {
    visit.field("mouse_sensitivity", controls.mouse_sensitivity, {.min = 0.1, .max = 10, .help = "Factor on how far the mouse turns the view.", .look = FieldLook::logarithmic});
    visit.field("invert_y", controls.invert_y, {.help = "Mouse or stick forward looks down instead of up."});
    visit.field("gamepad_sensitivity", controls.gamepad_sensitivity, {.min = 0.1, .max = 10, .help = "Factor on how fast a gamepad's right stick turns the view.", .look = FieldLook::logarithmic});
    visit.field("dead_zone", controls.dead_zone, {.min = 0, .max = 0.9, .help = "How far a gamepad's stick must be moved before it counts; more where the view drifts by itself."});
}

void visit_fields(FieldVisitor& visit, PictureSettings& picture) {
    visit.field("fullscreen", picture.fullscreen, {.help = "Fills the screen."});
    visit.field("vsync", picture.vsync, {.help = "Draws in step with the screen: nothing tears, and no frame is drawn that is not shown."});
    visit.field("render_scale", picture.render_scale, {.min = 0.05, .max = 4, .help = "Pixels drawn per pixel shown, along each axis; less is quicker and coarser."});
    visit.field("scene_field_of_view", picture.scene_field_of_view, {.help = "Leaves the field of view as the scene has it."});
    visit.field("field_of_view", picture.field_of_view, {.min = 0.5236, .max = 2.0944, .unit = "rad", .help = "Vertical angle of view, where it is not the scene's; more shows more and makes things smaller.", .look = FieldLook::angle});
    visit.field("view_distance", picture.view_distance, {.min = 32, .max = 512, .unit = "m", .help = "How far off land is made and shown in worlds that go on without end; more costs memory and time.", .look = FieldLook::logarithmic});
    visit.field("least_frame_rate", picture.least_frame_rate, {.min = 0, .max = 60, .unit = "Hz", .help = "While frames come more rarely, such land is shown less far, down to half the view distance; 0 always shows all."});
}

void visit_fields(FieldVisitor& visit, LightSettings& light) {
    visit.choice("method", light.method, method_names(), {.help = "How indirect light is computed; see `secondlight list methods`."});
    visit.choice("preset", light.preset, preset_names, {.help = "Measured settings of a chosen method that has presets: cheap, or near to the truth."});
    visit.field("quality", light.quality, {.min = 0, .max = 1, .help = "Of the method facets, where it is chosen here: 0 is coarse and soon there, 1 fine and ten times later."});
    visit.field("budget_ms", light.budget_ms, {.min = 0.5, .max = 1000, .unit = "ms", .help = "What the method facets, where it is chosen here, may take of a frame.", .look = FieldLook::logarithmic});
}

std::string_view preset_name(const LightSettings& light) {
    return light.preset == 0 ? std::string_view() : preset_names[light.preset];
}

}  // namespace sl
