// SPDX-License-Identifier: MIT
#include "engine/core/field_clamp.h"

#include <gtest/gtest.h>

#include "engine/core/field_random.h"
#include "engine/core/field_range.h"
#include "tests/core/every_field.h"

namespace sl {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

TEST(FieldClamp, MovesToTheNearestValue) {
    EveryField every;
    every.steps = -100;
    every.size = 1u << 30;
    every.strength = 3.0f;
    every.angle = -infinite;
    every.colour = vec3(not_a_number, -1.0f, infinite);
    every.open = not_a_number;
    every.mood = static_cast<EveryField::Mood>(9);
    clamp_fields(every);
    EXPECT_EQ(every.steps, -10);
    EXPECT_EQ(every.size, 1024u);
    EXPECT_EQ(every.strength, 0.7f);
    EXPECT_EQ(every.angle, 0.001f);
    EXPECT_EQ(every.colour, vec3(0.0f, 0.0f, 1.0f));
    EXPECT_EQ(every.open, 0.0f);
    EXPECT_EQ(every.mood, EveryField::Mood::stormy);
}

TEST(FieldClamp, MakesRotationsUnit) {
    EveryField every;
    every.rotation = quat(2, 0, 0, 0);
    clamp_fields(every);
    EXPECT_EQ(every.rotation, quat(1, 0, 0, 0));
    every.rotation = quat(not_a_number, 0, 0, 0);
    clamp_fields(every);
    EXPECT_EQ(every.rotation, quat(1, 0, 0, 0));
}

TEST(FieldClamp, LeavesRandomFieldsAlone) {
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        EveryField every;
        RandomFields random(seed);
        visit_fields(random, every);
        EveryField clamped = every;
        clamp_fields(clamped);
        EXPECT_TRUE(same_bits(every, clamped)) << seed;
    }
}

TEST(RandomFields, RepeatsForASeedAndDiffersBetweenSeeds) {
    EveryField a, b, c;
    RandomFields first(5), again(5), other(6);
    visit_fields(first, a);
    visit_fields(again, b);
    visit_fields(other, c);
    EXPECT_TRUE(same_bits(a, b));
    EXPECT_FALSE(same_bits(a, c));
}

TEST(RandomFields, ReachesLimitsAndSpreadsLogarithmically) {
    int low = 0, high = 0, small = 0;
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        EveryField every;
        RandomFields random(seed);
        visit_fields(random, every);
        low += every.strength == 0.0f;
        high += every.strength == 0.7f;
        small += every.brightness > 0.0f && every.brightness < 1e6f;
        EXPECT_NEAR(glm::length(every.rotation), 1.0f, 1e-6f);
    }
    EXPECT_NEAR(low, 125, 50);
    EXPECT_NEAR(high, 125, 50);
    EXPECT_NEAR(small, 875, 120);
}

TEST(FieldRange, WholeTypesRoundInwards) {
    const FieldInfo info{.min = -1.5, .max = 3.7};
    EXPECT_EQ(field_range<std::int32_t>(info).low, -1);
    EXPECT_EQ(field_range<std::int32_t>(info).high, 3);
    EXPECT_EQ(field_range<std::uint32_t>(info).low, 0u);
    EXPECT_EQ(field_range<std::uint32_t>({}).high, std::numeric_limits<std::uint32_t>::max());
    EXPECT_FALSE(inside_range<std::uint32_t>(4294967296.0, {}));
}

}  // namespace
}  // namespace sl
