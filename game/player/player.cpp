// SPDX-License-Identifier: MIT
#include "game/player/player.h"

#include <cmath>

#include "engine/core/clock.h"
#include "engine/core/input.h"
#include "engine/ecs/components/transform.h"
#include "engine/ecs/parent.h"
#include "game/fly_camera.h"
#include "game/player/voxel_surroundings.h"
#include "game/session.h"

namespace sl {

namespace {

/// How far below the camera ground may be for a game to begin on foot, m.
constexpr double near_ground = 3.0;
/// What a slow machine does not simulate is lost, s: a second that takes two to simulate would never end.
constexpr double most_unspent = 0.25;

BodyWish wish_of(const Input& input, const quat& rotation) {
    const vec3 right = rotation * vec3(1, 0, 0);
    BodyWish wish;
    if (input.active(Key::control)) return wish;  // Ctrl+Q is no walk
    wish.heading = std::atan2(-right.z, right.x);
    wish.move = glm::clamp(vec2(input.axis(Key::d, Key::a), input.axis(Key::w, Key::s)) + input.stick, -1.0f, 1.0f);
    wish.jump = input.active(Key::space);
    wish.run = input.active(Key::shift);
    wish.crouch = input.active(Key::c);
    return wish;
}

void stand_where(Player& player, const dvec3& eyes) {
    player.body = {};
    player.body.feet = eyes - (player.body.eyes() - player.body.feet);
    player.before = player.body;
    player.unspent = 0.0;
}

void begin(Player& player, const dvec3& eyes, World& world) {
    stand_where(player, eyes);
    if (!land_is_there(world, player.body.box())) return;
    player.decided = true;
    const Surroundings around = voxel_surroundings(world);
    BodyBox below = player.body.box();
    below.high.y = below.low.y;
    below.low.y = eyes.y - near_ground;
    player.flying = !around.solid(below) || around.solid(player.body.box());
}

void choose_flight(World& world, Player& player, const Input& input) {
    if (!input.pressed(Key::v) || input.active(Key::control)) return;
    player.flying = !player.flying;
    world.resource<Notice>().say(player.flying ? "flying: V to walk" : "walking: V to fly");
}

}  // namespace

void walk(World& world) {
    const Entity camera = active_camera(world);
    auto* place = camera ? world.find<Transform>(camera) : nullptr;
    if (place == nullptr) return;
    auto& player = world.resource<Player>();
    const auto& input = world.resource<Input>();
    auto& fly = world.resource<FlyCamera>();
    const bool bound = world.has<Parent>(camera);
    // Not before it is known where things stand.
    if (!player.decided && world.has<WorldTransform>(camera)) begin(player, place->translation, world);
    choose_flight(world, player, input);
    fly.active = player.flying || bound;
    if (fly.active) {
        player.shown = dvec3(std::numeric_limits<double>::quiet_NaN());
        return;
    }
    if (place->translation != player.shown) stand_where(player, place->translation);
    if (input.mouse_delta != vec2(0.0f)) place->rotation = look_turned(place->rotation, input.mouse_delta * fly.radians_per_unit);
    const BodyWish wish = wish_of(input, place->rotation);
    player.unspent = std::min(player.unspent + world.resource<FrameClock>().step, most_unspent);
    // Whoever comes to land that is still to come waits for it.
    if (!land_is_there(world, player.body.box())) player.unspent = 0.0;
    const Surroundings around = voxel_surroundings(world);
    for (; player.unspent >= Player::step; player.unspent -= Player::step) {
        player.before = player.body;
        move_body(player.body, wish, Player::step, around);
    }
    place->translation = player.shown = glm::mix(player.before.eyes(), player.body.eyes(), player.unspent / Player::step);
}

bool player_is_in(World& world, const BodyBox& box) {
    const auto* player = world.find_resource<Player>();
    if (player == nullptr || player->flying) return false;
    const BodyBox own = player->body.box();
    return glm::all(glm::lessThan(own.low, box.high)) && glm::all(glm::lessThan(box.low, own.high));
}

void add_player(App& app) {
    add_player_resources(app.world);
    app.world.add_resource(Player{});
    app.schedule.add(Stage::simulate, "walk", &walk);
}

}  // namespace sl
