// SPDX-License-Identifier: MIT
#include "engine/core/field_setter.h"

#include <gtest/gtest.h>

#include "engine/core/field_list.h"
#include "engine/core/field_random.h"
#include "tests/core/every_field.h"

namespace sl {
namespace {

EveryField set(std::string_view name, std::string_view text) {
    EveryField every;
    set_field(every, "every", name, text);
    return every;
}

std::string error_for(std::string_view name, std::string_view text) {
    return error_of([&] { set(name, text); });
}

TEST(FieldSetter, SetsEachType) {
    EXPECT_TRUE(set("flag", "true").flag);
    EXPECT_EQ(set("steps", "-7").steps, -7);
    EXPECT_EQ(set("size", " 128 ").size, 128u);
    EXPECT_EQ(set("strength", "0.3").strength, 0.3f);
    EXPECT_EQ(set("precise", "1e-3").precise, 1e-3);
    EXPECT_EQ(set("colour", "1,0.5, 0.2").colour, vec3(1.0f, 0.5f, 0.2f));
    EXPECT_EQ(set("rotation", "0,1,0,0").rotation, quat(0, 0, 1, 0));
    EXPECT_EQ(set("text", "a,b=c").text, "a,b=c");
    EXPECT_EQ(set("mood", "windy").mood, EveryField::Mood::windy);
}

TEST(FieldSetter, TakesDegreesForAngles) {
    EXPECT_FLOAT_EQ(set("angle", "30deg").angle, pi / 6.0f);
    EXPECT_FLOAT_EQ(set("angle", "30 deg").angle, pi / 6.0f);
    EXPECT_EQ(error_for("angle", "200deg"), "every.angle: is 3.490658503988659, must be 0.001 to 1.5533 rad");
    EXPECT_EQ(error_for("strength", "30deg"), "every.strength: '30deg' is not a number");
}

TEST(FieldSetter, LeavesOtherFieldsAlone) {
    EveryField expected;
    expected.strength = 0.5f;
    EXPECT_TRUE(same_bits(set("strength", "0.5"), expected));
}

TEST(FieldSetter, ErrorsSayWhatFits) {
    EXPECT_EQ(error_for("size", "4096"), "every.size: is 4096, must be 4 to 1024 texels");
    EXPECT_EQ(error_for("strength", "nan"), "every.strength: is nan, must be 0 to 0.7");
    EXPECT_EQ(error_for("strength", ""), "every.strength: '' is not a number");
    EXPECT_EQ(error_for("angle", "steep"),
              "every.angle: 'steep' is not a number; write radians, or degrees as 30deg");
    EXPECT_EQ(error_for("colour", "1"), "every.colour: needs 3 numbers with commas between, has 1");
    EXPECT_EQ(error_for("strength", "1,2"), "every.strength: needs 1 number with commas between, has 2");
    EXPECT_EQ(error_for("flag", "1"), "every.flag: must be true or false, is '1'");
    EXPECT_EQ(error_for("mood", "angry"),
              "every.mood: there is no choice 'angry'. Known: calm, windy, stormy");
    EXPECT_EQ(error_for("strenght", "1"),
              "every: there is no field 'strenght'; did you mean 'strength'? Known: flag, steps, size, "
              "strength, angle, "
              "brightness, open, precise, pair, colour, place, rotation, text, mood");
}

TEST(FieldSetter, ReadsWhatTheListShows) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        EveryField before;
        RandomFields random(seed);
        visit_fields(random, before);
        EveryField after;
        for (const FieldRow& row : list_fields(before)) set_field(after, "every", row.name, row.value);
        EXPECT_TRUE(same_bits(before, after)) << seed;
    }
}

}  // namespace
}  // namespace sl
