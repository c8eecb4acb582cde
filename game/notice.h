// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/core/input.h"
#include "engine/ecs/world.h"

namespace sl {

/// A sentence for the player that goes away by itself; a resource.
struct Notice {
    std::string text;
    double seconds_left = 0.0;

    void say(std::string sentence, double seconds = 2.5) {
        text = std::move(sentence);
        seconds_left = seconds;
    }
};

/// Input and Notice, where they are missing: what the systems that a player steers rely on.
inline void add_player_resources(World& world) {
    if (world.find_resource<Input>() == nullptr) world.add_resource(Input{});
    if (world.find_resource<Notice>() == nullptr) world.add_resource(Notice{});
}

}  // namespace sl
