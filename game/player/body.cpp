// SPDX-License-Identifier: MIT
#include "game/player/body.h"

#include <algorithm>
#include <cmath>

namespace sl {

namespace {

// m/s and m/s²: gravity and jump are stronger than on Earth, as in most games, for a jump of 1.2 m in 0.7 s.
constexpr double walking = 4.3, running = 7.0, sneaking = 1.6, swimming = 2.6;
constexpr double gravity = 20.0, jump_speed = 7.0, fastest_fall = 55.0;
/// How quickly velocity follows what is wanted, 1/s.
constexpr double grip_on_ground = 14.0, grip_in_air = 2.5, grip_in_water = 5.0;
/// How quickly eyes follow feet, 1/s.
constexpr double eyes_follow = 14.0;
/// Longest way between two looks at what is solid, m: thinner things than that are not there.
constexpr double longest_way = 0.1;
/// A contact is found to within this, m.
constexpr double contact = 1e-4;
constexpr double way_out = 2.0, way_out_step = 0.05;

dvec3 along(int axis, double distance) {
    dvec3 way(0.0);
    way[axis] = distance;
    return way;
}

bool free_at(const Body& body, const dvec3& feet, const Surroundings& around) { return !around.solid(Body::box_at(feet, body.height())); }

/// Moves along one axis as far as nothing is in the way. Returns whether something was.
bool move_along(Body& body, int axis, double distance, const Surroundings& around) {
    const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(distance) / longest_way)));
    for (int part = 0; part < parts; ++part) {
        const dvec3 way = along(axis, distance / parts);
        if (free_at(body, body.feet + way, around)) {
            body.feet += way;
            continue;
        }
        double clear = 0.0, blocked = 1.0;
        while ((blocked - clear) * glm::length(way) > contact) {
            const double middle = 0.5 * (clear + blocked);
            (free_at(body, body.feet + middle * way, around) ? clear : blocked) = middle;
        }
        body.feet += clear * way;
        return true;
    }
    return false;
}

/// Walks sideways; onto a step, where one is in the way. Returns which axes were blocked.
glm::bvec2 move_level(Body& body, const dvec3& way, bool can_step, const Surroundings& around) {
    Body direct = body;
    const glm::bvec2 blocked(move_along(direct, 0, way.x, around), move_along(direct, 2, way.z, around));
    if (!glm::any(blocked) || !can_step) {
        body = direct;
        return blocked;
    }
    Body lifted = body;
    move_along(lifted, 1, Body::step, around);
    const double height = lifted.feet.y - body.feet.y;
    const glm::bvec2 still_blocked(move_along(lifted, 0, way.x, around), move_along(lifted, 2, way.z, around));
    move_along(lifted, 1, -height, around);
    const auto gone = [&](const Body& other) { return glm::length(glm::dvec2(other.feet.x - body.feet.x, other.feet.z - body.feet.z)); };
    if (gone(lifted) <= gone(direct) + contact) {
        body = direct;
        return blocked;
    }
    lifted.stepped += lifted.feet.y - body.feet.y;
    body = lifted;
    return still_blocked;
}

void get_out(Body& body, const Surroundings& around) {
    for (double up = way_out_step; up <= way_out; up += way_out_step) {
        if (!free_at(body, body.feet + along(1, up), around)) continue;
        body.feet.y += up;
        body.velocity = dvec3(0.0);
        return;
    }
}

void crouch(Body& body, bool wanted, const Surroundings& around) {
    if (wanted == body.crouched) return;
    // Under a low ceiling nobody stands up.
    if (!wanted && around.solid(Body::box_at(body.feet, Body::standing))) return;
    // Eyes move over some frames, as on a step.
    body.stepped += wanted ? Body::crouching - Body::standing : Body::standing - Body::crouching;
    body.crouched = wanted;
}

dvec3 wanted_velocity(const Body& body, const BodyWish& wish) {
    const double speed = body.swimming ? swimming : body.crouched ? sneaking : wish.run ? running : walking;
    const double length = std::max(1.0f, glm::length(wish.move));
    const dvec3 right(std::cos(wish.heading), 0.0, -std::sin(wish.heading)), forward(-std::sin(wish.heading), 0.0, -std::cos(wish.heading));
    return (right * double{wish.move.x} + forward * double{wish.move.y}) * (speed / length);
}

void accelerate(Body& body, const BodyWish& wish, double seconds) {
    const double grip = body.swimming ? grip_in_water : body.grounded ? grip_on_ground : grip_in_air;
    const dvec3 wanted = wanted_velocity(body, wish);
    const double part = 1.0 - std::exp(-grip * seconds);
    body.velocity.x += (wanted.x - body.velocity.x) * part;
    body.velocity.z += (wanted.z - body.velocity.z) * part;
    if (body.swimming) {
        // Bodies sink slowly; whoever wants up or down swims there.
        const double rise = wish.jump ? swimming : wish.crouch ? -swimming : -0.4;
        body.velocity.y += (rise - body.velocity.y) * part;
    } else {
        body.velocity.y = std::max(body.velocity.y - gravity * seconds, -fastest_fall);
        if (wish.jump && body.grounded) body.velocity.y = jump_speed;
    }
}

}  // namespace

BodyBox Body::box_at(const dvec3& feet, double height) {
    const dvec3 half(0.5 * width, 0.0, 0.5 * width);
    return {feet - half, feet + half + dvec3(0.0, height, 0.0)};
}

void move_body(Body& body, const BodyWish& wish, double seconds, const Surroundings& around) {
    if (around.solid(body.box())) get_out(body, around);
    const bool inside = around.solid(body.box());
    const Surroundings none{.solid = [](const BodyBox&) { return false; }, .water = around.water};
    const Surroundings& hard = inside ? none : around;

    // Chest deep.
    body.swimming = around.water(body.feet + dvec3(0.0, 0.6 * body.height(), 0.0));
    crouch(body, wish.crouch && !body.swimming, hard);
    accelerate(body, wish, seconds);
    // Whoever swims against a bank climbs out.
    const bool at_a_bank = body.swimming && wish.jump;
    const bool wading = around.water(body.feet + dvec3(0.0, 0.2, 0.0));
    const glm::bvec2 blocked = move_level(body, dvec3(body.velocity.x, 0.0, body.velocity.z) * seconds, body.grounded || wading, hard);
    if (blocked.x) body.velocity.x = 0.0;
    if (blocked.y) body.velocity.z = 0.0;
    if (at_a_bank && glm::any(blocked)) body.velocity.y = std::max(body.velocity.y, 0.75 * jump_speed);

    const bool falls = body.velocity.y <= 0.0;
    const bool stopped = move_along(body, 1, body.velocity.y * seconds, hard);
    if (stopped) body.velocity.y = 0.0;
    // Down a step without a fall.
    const bool was_grounded = body.grounded;
    body.grounded = stopped && falls;
    if (was_grounded && falls && !body.grounded && !body.swimming) {
        Body lower = body;
        if (move_along(lower, 1, -Body::step, hard)) {
            lower.stepped += lower.feet.y - body.feet.y;
            lower.velocity.y = 0.0;
            lower.grounded = true;
            body = lower;
        }
    }
    body.stepped *= std::exp(-eyes_follow * seconds);
}

}  // namespace sl
