// SPDX-License-Identifier: MIT
#include "engine/ecs/component_pool.h"

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <random>
#include <string>
#include <variant>

namespace sl {
namespace {

struct Label {
    std::string text;
    std::variant<int, std::string> more;
};

TEST(ComponentPool, finds_what_was_added_and_nothing_else) {
    ComponentPool<Label> pool;
    pool.add({7, 1}, {"seven", 7});
    ASSERT_NE(pool.find({7, 1}), nullptr);
    EXPECT_EQ(pool.get({7, 1}).text, "seven");
    EXPECT_EQ(pool.find({7, 3}), nullptr) << "another generation";
    EXPECT_EQ(pool.find({8, 1}), nullptr) << "another index on the same page";
    EXPECT_EQ(pool.find({5'000'000, 1}), nullptr) << "a page that was never made";
    EXPECT_EQ(pool.find({}), nullptr) << "the null entity";
    EXPECT_EQ(pool.find({8, 0}), nullptr) << "a free slot is not generation 0";
}

TEST(ComponentPool, add_replaces) {
    ComponentPool<Label> pool;
    pool.add({1, 1}, {"old", 1});
    const std::uint64_t version = pool.version();
    pool.add({1, 1}, {"new", 2});
    EXPECT_EQ(pool.size(), 1u);
    EXPECT_EQ(pool.get({1, 1}).text, "new");
    EXPECT_EQ(pool.version(), version) << "nobody moved";
}

TEST(ComponentPool, erase_moves_the_last_into_the_hole) {
    ComponentPool<int> pool;
    for (std::uint32_t i = 0; i < 4; ++i) pool.add({i, 1}, static_cast<int>(10 * i));
    EXPECT_TRUE(pool.erase({1, 1}));
    EXPECT_FALSE(pool.erase({1, 1}));
    ASSERT_EQ(pool.size(), 3u);
    EXPECT_EQ(pool.entities()[1], (Entity{3, 1}));
    EXPECT_EQ(pool.values()[1], 30);
    EXPECT_EQ(pool.position({3, 1}), 1u);
}

TEST(ComponentPool, holds_values_that_only_move) {
    ComponentPool<std::unique_ptr<int>> pool;
    pool.add({0, 1}, std::make_unique<int>(1));
    pool.add({1, 1}, std::make_unique<int>(2));
    pool.erase({0, 1});
    EXPECT_EQ(*pool.get({1, 1}), 2);
    pool.erase({1, 1});
    EXPECT_EQ(pool.size(), 0u);
}

TEST(ComponentPool, clear_forgets_all_and_can_be_filled_again) {
    ComponentPool<int> pool;
    for (std::uint32_t i = 0; i < 3000; ++i) pool.add({i, 1}, 1);
    pool.clear();
    EXPECT_EQ(pool.size(), 0u);
    EXPECT_FALSE(pool.contains({5, 1}));
    pool.add({5, 3}, 2);
    EXPECT_EQ(pool.get({5, 3}), 2);
}

TEST(ComponentPool, swap_positions_keeps_values_with_their_entities) {
    ComponentPool<int> pool;
    for (std::uint32_t i = 0; i < 3; ++i) pool.add({i, 1}, static_cast<int>(i));
    pool.swap_positions(0, 2);
    EXPECT_EQ(pool.entities()[0], (Entity{2, 1}));
    for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(pool.get({i, 1}), static_cast<int>(i));
}

TEST(ComponentPool, only_touched_blocks_change_version) {
    ComponentPool<int> pool;
    for (std::uint32_t i = 0; i < 3 * PoolIndex::block_size; ++i) pool.add({i, 1}, 0);
    const auto versions = [&] {
        return std::array{pool.block_version(0), pool.block_version(1), pool.block_version(2)};
    };
    const auto before = versions();
    pool.erase({5, 1});
    const auto after = versions();
    EXPECT_GT(after[0], before[0]) << "the hole";
    EXPECT_EQ(after[1], before[1]);
    EXPECT_GT(after[2], before[2]) << "the last one left";
}

// Against the plainest model that can be written: a map from index to generation and value.
TEST(ComponentPool, behaves_like_a_map_under_random_changes) {
    struct Known {
        std::uint32_t generation;
        int value;
    };
    ComponentPool<Label> pool;
    std::map<std::uint32_t, Known> model;
    std::mt19937 random(1);
    for (int step = 0; step < 20'000; ++step) {
        const std::uint32_t index = random() % 3000;
        const auto known = model.find(index);
        const int value = static_cast<int>(random() % 1000);
        if (random() % 1000 == 0 && step % 2 == 0) {
            pool.clear();
            model.clear();
        } else if (known == model.end()) {
            const std::uint32_t generation = 1 + 2 * (random() % 3);
            pool.add({index, generation}, {std::to_string(value), value});
            model[index] = {generation, value};
        } else if (random() % 3 == 0) {
            pool.add({index, known->second.generation}, {std::to_string(value), value});
            known->second.value = value;
        } else {
            EXPECT_FALSE(pool.erase({index, known->second.generation + 2}));
            EXPECT_TRUE(pool.erase({index, known->second.generation}));
            model.erase(known);
        }
        if (step % 500 != 0) continue;
        ASSERT_EQ(pool.size(), model.size());
        for (const auto& [known_index, entry] : model) {
            const Label* label = pool.find({known_index, entry.generation});
            ASSERT_NE(label, nullptr);
            ASSERT_EQ(label->text, std::to_string(entry.value));
            ASSERT_EQ(std::get<int>(label->more), entry.value);
        }
        for (std::uint32_t i = 0; i < pool.size(); ++i) ASSERT_EQ(pool.position(pool.entities()[i]), i);
    }
}

TEST(ComponentPoolDeathTest, get_of_a_missing_component_names_the_type) {
    ComponentPool<Label> pool;
    EXPECT_DEATH(pool.get({3, 1}), "entity 3 \\(generation 1\\) has no Label");
}

TEST(ComponentPoolDeathTest, two_generations_of_one_index_stop) {
    ComponentPool<int> pool;
    pool.add({3, 1}, 0);
    EXPECT_DEATH(pool.add({3, 5}, 0), "with generation 1, not 5");
}

TEST(ComponentPoolDeathTest, a_pinned_pool_does_not_change) {
    ComponentPool<int> pool;
    pool.add({3, 1}, 0);
    const PoolIndex::Pin pin(&pool);
    pool.add({3, 1}, 1);  // replacing moves nobody
    EXPECT_DEATH(pool.add({4, 1}, 0), "use Commands");
    EXPECT_DEATH(pool.erase({3, 1}), "use Commands");
    EXPECT_DEATH(pool.clear(), "use Commands");
}

}  // namespace
}  // namespace sl
