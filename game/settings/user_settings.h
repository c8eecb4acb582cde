// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/math.h"
#include "game/settings/key_bindings.h"

namespace sl {

struct ControlSettings {
    float mouse_sensitivity = 1.0f;
    bool invert_y = false;
    float gamepad_sensitivity = 1.0f;
    float dead_zone = 0.15f;

    bool operator==(const ControlSettings&) const = default;
};

struct PictureSettings {
    bool fullscreen = false;
    bool vsync = true;
    double render_scale = 1.0;
    bool scene_field_of_view = true;
    float field_of_view = pi / 3.0f;
    double view_distance = 96.0;
    double least_frame_rate = 20.0;

    bool operator==(const PictureSettings&) const = default;
};

/// Indirect light; method and preset count from 1, and 0 leaves them as they are.
struct LightSettings {
    std::size_t method = 0, preset = 0;
    float quality = 0.5f;
    float budget_ms = 10.0f;

    bool operator==(const LightSettings&) const = default;
};

/// What a player has chosen for all games on this machine; a resource where a window is open.
struct UserSettings {
    ControlSettings controls;
    PictureSettings picture;
    LightSettings light;
    KeyBindings keys;

    bool operator==(const UserSettings&) const = default;
};

void visit_fields(FieldVisitor& visit, ControlSettings& controls);
void visit_fields(FieldVisitor& visit, PictureSettings& picture);
void visit_fields(FieldVisitor& visit, LightSettings& light);

/// Calls visit(name, section) for each part of the settings.
template <class Settings, class Visit>
void each_section(Settings& settings, Visit visit) {
    visit("controls", settings.controls);
    visit("picture", settings.picture);
    visit("light", settings.light);
    visit("keys", settings.keys);
}

/// The preset that the settings ask for, "low"; empty for the method's usual values.
std::string_view preset_name(const LightSettings& light);

}  // namespace sl
