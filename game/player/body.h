// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "engine/core/math.h"

namespace sl {

/// An axis-aligned box in world space, m.
struct BodyBox {
    dvec3 low, high;
};

/// What a body moves among.
struct Surroundings {
    /// Whether anything solid reaches into the box; touching is not reaching into.
    std::function<bool(const BodyBox&)> solid;
    std::function<bool(const dvec3&)> water;
};

/// What somebody wants to do, in the direction in which they look.
struct BodyWish {
    vec2 move{0.0f};  ///< right and forward, each -1 to 1
    double heading = 0.0;  ///< rad about the vertical; 0 looks along -z
    bool jump = false, run = false, crouch = false;
};

/// Someone who walks, runs, jumps, crouches, swims and falls.
struct Body {
    dvec3 feet{0.0};
    dvec3 velocity{0.0};  ///< m/s
    bool grounded = false, crouched = false, swimming = false;
    double stepped = 0.0;  ///< m by which the feet were lifted onto a step and the eyes have not followed yet

    static constexpr double width = 0.6, standing = 1.8, crouching = 1.2;  ///< m
    /// What a body walks up without a jump: a block of half a metre.
    static constexpr double step = 0.55;

    double height() const { return crouched ? crouching : standing; }
    dvec3 eyes() const { return feet + dvec3(0.0, height() - 0.15 - stepped, 0.0); }
    BodyBox box() const { return box_at(feet, height()); }
    static BodyBox box_at(const dvec3& feet, double height);
};

/// One step of simulation, s. However fast, a body never reaches into what is solid; one that something was built into gets
/// out upwards where there is room within two metres, and moves freely until it is out elsewhere.
void move_body(Body& body, const BodyWish& wish, double seconds, const Surroundings& around);

}  // namespace sl
