// SPDX-License-Identifier: MIT
#include "engine/ecs/alignment.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/ecs/component_pool.h"

namespace sl {
namespace {

constexpr std::uint32_t block = PoolIndex::block_size;

struct Alignments : testing::Test {
    ComponentPool<int> a;
    ComponentPool<float> b;
    AlignmentCache cache;

    const Alignment& find() {
        const PoolIndex* pools[] = {&a, &b};
        return cache.find(0, pools);
    }
    void fill(std::uint32_t in_a, std::uint32_t in_b) {
        for (std::uint32_t i = 0; i < in_a; ++i) a.add({i, 1}, 0);
        for (std::uint32_t i = 0; i < in_b; ++i) b.add({i, 1}, 0.0f);
    }
    void expect_true_to_the_pools() {
        const Alignment& alignment = find();
        const PoolIndex& leader = alignment.leader == 0 ? static_cast<PoolIndex&>(a) : b;
        ASSERT_EQ(leader.size(), std::min(a.size(), b.size()));
        std::uint32_t covered = 0;
        for (const Stretch& stretch : alignment.stretches) {
            ASSERT_EQ(stretch.first, covered);
            covered = stretch.last;
            if (!stretch.aligned) continue;
            for (std::uint32_t i = stretch.first; i < stretch.last; ++i)
                ASSERT_EQ(a.entities()[i], b.entities()[i]);
        }
        ASSERT_EQ(covered, leader.size());
    }
};

TEST_F(Alignments, equal_pools_are_one_run_led_by_the_smaller) {
    fill(3 * block + 5, 2 * block + 7);
    const Alignment& alignment = find();
    EXPECT_EQ(alignment.leader, 1u);
    ASSERT_EQ(alignment.stretches.size(), 1u);
    EXPECT_TRUE(alignment.stretches[0].aligned);
    EXPECT_EQ(alignment.stretches[0].last, 2 * block + 7);
}

TEST_F(Alignments, a_swap_in_the_middle_costs_only_its_block) {
    fill(4 * block, 4 * block);
    find();
    a.swap_positions(block, block + 1);
    ASSERT_EQ(find().stretches.size(), 3u);
    EXPECT_FALSE(find().stretches[1].aligned);
    EXPECT_EQ(find().stretches[1].first, block);
    EXPECT_EQ(find().stretches[1].last, 2 * block);
    b.swap_positions(block, block + 1);
    EXPECT_EQ(find().stretches.size(), 1u);
}

TEST_F(Alignments, destroying_from_both_keeps_them_aligned) {
    fill(2 * block, 2 * block);
    find();
    a.erase({10, 1});
    b.erase({10, 1});
    ASSERT_EQ(find().stretches.size(), 1u);
    EXPECT_TRUE(find().stretches[0].aligned);
}

TEST_F(Alignments, empty_pools_have_no_runs) {
    EXPECT_TRUE(find().stretches.empty());
    fill(5, 0);
    EXPECT_TRUE(find().stretches.empty());
}

TEST_F(Alignments, claims_only_what_is_so_under_random_changes) {
    std::mt19937 random(2);
    fill(5 * block, 5 * block);
    for (int step = 0; step < 4000; ++step) {
        const Entity entity{static_cast<std::uint32_t>(random() % (6 * block)), 1};
        const bool both = random() % 2 == 0;
        if (a.contains(entity)) {
            a.erase(entity);
            if (both) b.erase(entity);
        } else {
            a.add(entity, 0);
            if (both) b.add(entity, 0.0f);
        }
        if (step % 1000 == 999) {
            a.clear();
            b.clear();
            fill(2 * block, 3 * block);
        }
        if (step % 7 == 0) expect_true_to_the_pools();
    }
}

}  // namespace
}  // namespace sl
