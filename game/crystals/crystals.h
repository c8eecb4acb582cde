// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "engine/ecs/app.h"
#include "game/crystals/crystal.h"

namespace sl {

/// What the player sees of the search for crystals; a resource.
struct CrystalSearch {
    std::size_t awake = 0, all = 0;
    Entity nearest;                     ///< sleeping one, if any is near enough to be measured
    float distance = 0.0f;              ///< to it, m
    std::optional<CrystalLight> light;  ///< of it; none while nothing is known yet
    std::string hint;                   ///< asked for with T; empty once the player has gone on
    double lit_for = 0.0;               ///< s that the nearest has had all it needs
    double celebration = 0.0;           ///< s left of it
};

/// Measures the light at the nearest sleeping crystal with the world's LightMeter, and wakes it once it has had enough of it
/// for a moment. Glow and count follow `Crystal::awake`, whoever sets it.
void crystals(World& world);

/// Names of all that are awake, in order.
std::vector<std::string> awake_crystals(World& world);

/// The crystals as a plugin: the component "crystal", and the system.
void add_crystals(App& app);

}  // namespace sl
