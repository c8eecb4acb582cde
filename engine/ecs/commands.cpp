// SPDX-License-Identifier: MIT
#include "engine/ecs/commands.h"

namespace sl {

void Commands::apply(World& world) {
    CHECK(&world == world_, "commands recorded for one world are applied to another");
    for (const Command& command : recorded_) {
        if (world.alive(command.entity)) command.run(world, command.entity, command.values, command.item);
    }
    recorded_.clear();
    for (const std::unique_ptr<AnyValues>& values : values_) {
        if (values != nullptr) values->clear();
    }
}

}  // namespace sl
