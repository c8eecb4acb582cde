// SPDX-License-Identifier: MIT
#include "game/flashlight.h"

#include "engine/core/input.h"
#include "engine/ecs/components.h"
#include "engine/ecs/parent.h"
#include "game/notice.h"
#include "game/session.h"

namespace sl {

namespace {

/// Held beside the eyes, so that its shadows can be seen, m.
constexpr dvec3 in_hand{0.25, -0.2, 0.0};
/// Candela: as bright on a wall five metres off as a cloudy day.
constexpr float brightness = 60000.0f;
constexpr float reach = 60.0f;  ///< m

SpotLight lamp() {
    SpotLight light;
    light.colour = vec3(1.0f, 0.93f, 0.82f);
    light.intensity = brightness;
    light.range = reach;
    light.inner_cone = 0.12f;
    light.outer_cone = 0.36f;
    light.casts_shadow = true;
    light.bounces = true;
    return light;
}

}  // namespace

void flashlight(World& world) {
    auto& held = world.resource<Flashlight>();
    const Entity camera = active_camera(world);
    const bool on = held.light && world.alive(held.light);
    // Another camera than the one it was made for: it is put out.
    const bool elsewhere = on && world.get<Parent>(held.light).entity != camera;
    const auto& input = world.resource<Input>();
    if (!elsewhere && (!input.pressed(Key::f) || input.active(Key::control))) return;
    if (on) {
        world.destroy(held.light);
        held.light = {};
    } else if (camera) {
        held.light = world.create(Transform{.translation = in_hand}, Parent{camera}, lamp());
    }
}

void add_flashlight(App& app) {
    add_player_resources(app.world);
    app.world.add_resource(Flashlight{});
    app.schedule.add(Stage::input, "flashlight", &flashlight);
}

}  // namespace sl
