// SPDX-License-Identifier: MIT
#include "engine/ecs/entity.h"

#include <gtest/gtest.h>

#include <unordered_set>

namespace sl {
namespace {

TEST(Entity, is_null_by_default) {
    EXPECT_FALSE(Entity{});
    EXPECT_TRUE((Entity{0, 1}));
}

TEST(Entity, equals_only_with_the_same_generation) {
    EXPECT_EQ((Entity{3, 1}), (Entity{3, 1}));
    EXPECT_NE((Entity{3, 1}), (Entity{3, 3}));
    EXPECT_LT((Entity{3, 9}), (Entity{4, 1}));
}

TEST(Entity, hash_spreads_indices_and_generations) {
    std::unordered_set<std::size_t> low_bits;
    std::unordered_set<Entity> entities;
    for (std::uint32_t index = 0; index < 100; ++index) {
        for (std::uint32_t generation = 1; generation < 20; generation += 2) {
            entities.insert({index, generation});
            low_bits.insert(std::hash<Entity>{}({index, generation}));
        }
    }
    EXPECT_EQ(entities.size(), 1000u);
    EXPECT_EQ(low_bits.size(), 1000u);
}

}  // namespace
}  // namespace sl
