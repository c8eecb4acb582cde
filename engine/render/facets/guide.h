// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "engine/core/math.h"

namespace sl {

/// Where most light comes from at places near each other, though it is too small to be met often by chance: balls in
/// space. Each gets rays of its own, evenly in the cone that it fills, in proportion to what it brings.
struct Guide {
    /// A ball that rays are sent at.
    struct Target {
        vec3 place{0.0f};
        float radius = 0.0f;  ///< m
        float share = 0.0f;   ///< of the rays
        float before = 0.0f;  ///< sum of the shares of those before it
    };
    std::vector<Target> targets;

    bool empty() const { return targets.empty(); }
    /// Adds a ball, or lets one that it overlaps grow, up to a radius; with a share that is not over the sum of all yet.
    void add(vec3 place, float radius, float share, float widest);
    /// Keeps the brightest and makes shares of one; after all `add`.
    void finish(std::size_t most);

    /// What rays to a target have brought.
    struct Yield {
        float rays = 0.0f, squares = 0.0f;  ///< number; sum of their squared light
    };
    /// Gives targets the shares with which that light would have had the least variance (Neyman 1934). False, and nothing is
    /// changed, where that is not much less than it had.
    bool learn(const std::vector<Yield>& yields);

  private:
    void share_out();
};

/// A guide as seen from one point: the cones that its targets fill.
class GuideCones {
  public:
    GuideCones() = default;
    GuideCones(const Guide& guide, vec3 from);

    /// A unit direction, xi in [0, 1)². Not of an empty guide.
    vec3 sample(vec2 xi, float choice) const;
    /// Its density, per sr.
    float density(vec3 direction) const;
    /// Adds a ray that was sent in a direction, and its light, to those of the targets that may have sent it.
    void account(std::vector<Guide::Yield>& yields, vec3 direction, float light) const;

  private:
    struct Cone {
        vec3 axis{0, 0, 1};
        float versine = 2.0f;  ///< 1 - cos of its half angle; from inside a ball it is everything around
        float density = 0.0f;  ///< of directions in it, its share counted, per sr
        float before = 0.0f;   ///< sum of the shares of those before it

        bool holds(vec3 direction) const {
            const vec3 difference = direction - axis;  // 1 - cos = |difference|² / 2
            return 0.5f * glm::dot(difference, difference) <= versine;
        }
    };
    std::vector<Cone> cones_;
};

}  // namespace sl
