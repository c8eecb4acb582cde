// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "engine/core/math.h"

namespace sl {

/// Where most light comes from at places near each other, though it is too small to be met often by chance: balls in
/// space. Each gets rays of its own, evenly in the cone that it fills, in proportion to what it brings.
struct Guide {
    struct Target {
        vec3 place{0.0f};
        float radius = 0.0f;  ///< m
        float share = 0.0f;   ///< of the rays
        float before = 0.0f;  ///< sum of the shares of those before it
    };
    std::vector<Target> targets;

    bool empty() const { return targets.empty(); }
    /// Adds a ball, or lets one that it lies in grow, with a share that is not over the sum of all yet.
    void add(vec3 place, float radius, float share);
    /// Keeps the brightest and makes shares of one; after all `add`.
    void finish(std::size_t most);

    /// A unit direction from a point, xi in [0, 1)². Not when empty.
    vec3 sample(vec3 from, vec2 xi, float choice) const;
    /// Its density, per sr.
    float density(vec3 from, vec3 direction) const;
};

}  // namespace sl
