// SPDX-License-Identifier: MIT
#pragma once

#include "engine/ecs/app.h"
#include "game/player/body.h"

namespace sl {

/// Who plays: the active camera is at its eyes; a resource.
struct Player {
    Body body, before;  ///< after the last two steps of simulation; the picture shows a time between them
    double unspent = 0.0;  ///< s that have passed and are not simulated yet
    bool flying = true;    ///< the camera moves freely, through everything
    bool decided = false;  ///< whether the game begins on foot
    dvec3 shown{0.0};      ///< where the camera was put; elsewhere, somebody else has moved it

    static constexpr double step = 1.0 / 120.0;  ///< s, of the simulation
};

/// Walks the active camera through the blocks: WASD, Space jumps or swims up, Shift runs, C crouches or dives, V flies and lands.
/// A game begins on foot where there is ground within three metres below the camera. Cameras with a parent only fly.
void walk(World& world);

/// Whether whoever walks reaches into a box in world space.
bool player_is_in(World& world, const BodyBox& box);

/// The player as a plugin; needs a FrameClock when it runs.
void add_player(App& app);

}  // namespace sl
