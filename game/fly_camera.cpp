// SPDX-License-Identifier: MIT
#include "game/fly_camera.h"

#include <algorithm>
#include <cmath>

namespace sl {

namespace {

constexpr float steepest = 1.55f;  // rad
constexpr double speed_per_notch = 1.25;
constexpr double slowest = 0.05, fastest = 2000.0;  // m/s

}  // namespace

quat look_turned(const quat& rotation, vec2 radians) {
    const vec3 forward = rotation * vec3(0, 0, -1);
    const vec3 right = rotation * vec3(1, 0, 0);
    // Looking straight up or down, only the right axis still tells where the view is heading.
    const bool upright = std::abs(forward.y) < 0.999f;
    const float heading = upright ? std::atan2(-forward.x, -forward.z) : std::atan2(-right.z, right.x);
    const float pitch = std::asin(std::clamp(forward.y, -1.0f, 1.0f));
    const quat around = glm::angleAxis(heading - radians.x, vec3(0, 1, 0));
    const quat up = glm::angleAxis(std::clamp(pitch - radians.y, -steepest, steepest), vec3(1, 0, 0));
    return glm::normalize(around * up);
}

void fly_camera(Query<const Camera, Transform> cameras, const Input& input, const FrameClock& clock,
                FlyCamera& fly, Notice& notice) {
    if (!fly.active) return;
    const bool command = input.active(Key::control);  // Ctrl+Q is no flight
    if (command && input.scroll != 0.0f) {
        fly.speed = std::clamp(fly.speed * std::pow(speed_per_notch, input.scroll), slowest, fastest);
        notice.say(fmt::format("speed {:.3g} m/s", fly.speed));
    }
    const vec3 wish =
        command ? vec3(0.0f)
                : vec3(input.axis(Key::d, Key::a) + input.stick.x, input.axis(Key::e, Key::q), input.axis(Key::s, Key::w) - input.stick.y);
    const double pace = std::min(glm::length(wish), 1.0f);  // a stick may be half way
    for (auto [entity, camera, transform] : cameras) {
        if (!camera.active) continue;
        if (input.mouse_delta != vec2(0.0f)) {
            transform.rotation = look_turned(transform.rotation, input.mouse_delta * fly.radians_per_unit);
        }
        if (wish != vec3(0.0f)) {
            const vec3 right = transform.rotation * vec3(1, 0, 0);
            const vec3 level_right = glm::normalize(vec3(right.x, 0.0f, right.z) + vec3(1e-6f, 0.0f, 0.0f));
            const vec3 level_back = glm::cross(level_right, vec3(0, 1, 0));
            const vec3 direction =
                glm::normalize(level_right * wish.x + vec3(0, wish.y, 0) + level_back * wish.z);
            const double speed = fly.speed * pace * (input.active(Key::shift) ? fly.fast : 1.0);
            transform.translation += dvec3(direction) * (speed * clock.step);
        }
        break;
    }
}

void add_fly_camera(App& app) {
    add_player_resources(app.world);
    app.world.add_resource(FlyCamera{});
    app.schedule.add(Stage::simulate, "fly_camera", &fly_camera);
}

}  // namespace sl
