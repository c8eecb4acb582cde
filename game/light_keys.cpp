// SPDX-License-Identifier: MIT
#include "game/light_keys.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/core/clock.h"
#include "engine/core/input.h"
#include "engine/core/log.h"
#include "engine/ecs/components.h"
#include "engine/ecs/query.h"
#include "game/notice.h"
#include "game/session.h"

namespace sl {

namespace {

constexpr float azimuth_speed = 0.8f;    // rad/s
constexpr float elevation_speed = 0.4f;  // rad/s
constexpr float exposure_speed = 2.0f;   // EV/s
constexpr float drag_speed = 0.003f;     // rad per unit of mouse movement

void switch_method(World& world, Entity camera, std::string_view name) {
    auto& keys = world.resource<LightKeys>();
    if (const auto* now = world.find<GiSettings>(camera)) {
        keys.kept.insert_or_assign(now->method.name(), now->method);
        if (name == GiOff::name) keys.before_off = now->method.name();
    }
    const auto kept = keys.kept.find(name);
    const GiMethod method = kept != keys.kept.end() ? kept->second : make_gi_method(name);
    world.add(camera, GiSettings{method});
    log::info("GI: {}", name);
    world.resource<Notice>().say(fmt::format("GI: {}\n{}", name, method.claims()));
}

void method_keys(World& world, const Input& input, Entity camera) {
    const auto* settings = world.find<GiSettings>(camera);
    const GiMethod now = settings != nullptr ? settings->method : GiOff{};
    if (input.pressed(Key::g)) {
        const auto names = gi_method_names();
        switch_method(world, camera, names[(gi_method_index(now) + 1) % names.size()]);
    } else if (input.pressed(Key::o)) {
        const std::string_view before = world.resource<LightKeys>().before_off;
        const std::string_view brought_back = before.empty() ? GiSettings{}.method.name() : before;
        switch_method(world, camera, now.is<GiOff>() ? brought_back : GiOff::name);
    }
}

void exposure_keys(World& world, const Input& input, Entity camera, float seconds) {
    const float brighter = input.axis(Key::plus, Key::minus);
    if (brighter == 0.0f) return;
    auto& settings = world.get<Camera>(camera);
    settings.ev100 = std::clamp(settings.ev100 - brighter * exposure_speed * seconds, -10.0f, 24.0f);
    world.resource<Notice>().say(fmt::format("exposure EV {:.1f}", settings.ev100));
}

void turn_suns(World& world, float right, float up) {
    if (right == 0.0f && up == 0.0f) return;
    for (auto [entity, sun] : Query<SunAngles>(world)) {
        sun.azimuth = std::remainder(sun.azimuth + right, 2.0f * pi);
        sun.elevation = std::clamp(sun.elevation + up, -0.5f * pi, 0.5f * pi);
        world.resource<Notice>().say(fmt::format("sun: azimuth {:.0f} deg, elevation {:.0f} deg",
                                                 glm::degrees(sun.azimuth), glm::degrees(sun.elevation)));
    }
}

void sun_keys(World& world, const Input& input, float seconds) {
    const float turn = std::clamp(
        input.axis(Key::right, Key::left) + input.axis(Key::right_bracket, Key::left_bracket), -1.0f, 1.0f);
    const float rise = input.axis(Key::up, Key::down);
    turn_suns(world, turn * azimuth_speed * seconds, rise * elevation_speed * seconds);
}

void drag_sun(World& world, Input& input) {
    if (!input.active(Key::m) || input.active(Key::control)) return;
    const vec2 moved = std::exchange(input.mouse_delta, vec2(0.0f)) * drag_speed;
    turn_suns(world, moved.x, -moved.y);
}

void stop_or_go(World& world, const Input& input) {
    if (!input.pressed(Key::n) || input.active(Key::control)) return;
    std::string said = "in this scene the sun stands still";
    for (auto [entity, day] : Query<DayCycle>(world)) {
        day.runs = !day.runs;
        const auto minute = static_cast<int>(day.hour * 60.0);
        said = fmt::format("{:02}:{:02}, the day {}", minute / 60 % 24, minute % 60, day.runs ? "goes on" : "stands still");
    }
    world.resource<Notice>().say(said);
}

}  // namespace

void light_keys(World& world) {
    auto& input = world.resource<Input>();
    const auto seconds = static_cast<float>(world.resource<FrameClock>().step);
    sun_keys(world, input, seconds);
    drag_sun(world, input);
    stop_or_go(world, input);
    const Entity camera = active_camera(world);
    if (!camera) return;
    method_keys(world, input, camera);
    exposure_keys(world, input, camera, seconds);
}

void add_light_keys(App& app) {
    add_player_resources(app.world);
    app.world.add_resource(LightKeys{});
    app.schedule.add(Stage::input, "light_keys", &light_keys);
}

}  // namespace sl
