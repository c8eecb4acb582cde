// SPDX-License-Identifier: MIT
#include "engine/ecs/resources.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>

namespace sl {
namespace {

struct Clock {
    double seconds = 0.0;
};
struct Pinned {
    explicit Pinned(int start) : counter(start) {}
    std::atomic<int> counter;
};

TEST(Resources, one_value_of_each_type) {
    Resources resources;
    EXPECT_EQ(resources.find<Clock>(), nullptr);
    resources.add(Clock{1.5});
    resources.add(std::string("title"));
    EXPECT_EQ(resources.get<Clock>().seconds, 1.5);
    EXPECT_EQ(std::as_const(resources).get<std::string>(), "title");
    resources.add(Clock{2.5});
    EXPECT_EQ(resources.get<Clock>().seconds, 2.5);
    resources.remove<Clock>();
    EXPECT_EQ(resources.find<Clock>(), nullptr);
}

TEST(Resources, emplace_holds_what_cannot_move_and_takes_aggregates) {
    Resources resources;
    resources.emplace<Pinned>(3).counter++;
    EXPECT_EQ(resources.get<Pinned>().counter, 4);
    EXPECT_EQ(resources.emplace<Clock>(4.0).seconds, 4.0);
    EXPECT_EQ(resources.emplace<std::vector<int>>(std::size_t{5}, 1).size(), 5u);
}

TEST(Resources, addresses_stay_when_others_come) {
    Resources resources;
    const Clock* clock = &resources.add(Clock{1.0});
    resources.add(std::string());
    resources.add(0);
    resources.add(0.0f);
    EXPECT_EQ(resources.find<Clock>(), clock);
}

TEST(ResourcesDeathTest, get_of_a_missing_one_names_it) {
    Resources resources;
    EXPECT_DEATH(resources.get<Clock>(), "no resource Clock");
}

}  // namespace
}  // namespace sl
