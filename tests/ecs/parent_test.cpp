// SPDX-License-Identifier: MIT
#include "engine/ecs/parent.h"

#include <gtest/gtest.h>

#include "engine/ecs/world.h"

namespace sl {
namespace {

TEST(Parent, is_none_by_default_and_goes_stale_with_its_entity) {
    EXPECT_FALSE(Parent{}.entity);
    World world;
    const Entity parent = world.create();
    const Entity child = world.create(Parent{parent});
    world.destroy(parent);
    world.create();
    EXPECT_FALSE(world.alive(world.get<Parent>(child).entity));
}

}  // namespace
}  // namespace sl
