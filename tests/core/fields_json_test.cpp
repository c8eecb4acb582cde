// SPDX-License-Identifier: MIT
#include "engine/core/fields_json.h"

#include <gtest/gtest.h>

#include <bit>
#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/core/field_random.h"
#include "engine/core/json_text.h"
#include "tests/core/every_field.h"

namespace sl {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

EveryField read(const json& object) {
    EveryField every;
    JsonReader reader(object, "x.json: /a");
    visit_fields(reader, every);
    reader.check_all_used();
    return every;
}

ordered_json written(EveryField every) {
    ordered_json object;
    JsonWriter writer(object);
    visit_fields(writer, every);
    return object;
}

std::string error_for(const char* text) {
    return error_of([&] { read(json::parse(text)); });
}

TEST(FieldsJson, RoundTripKeepsEveryBitThroughText) {
    for (std::uint64_t seed = 0; seed < 500; ++seed) {
        EveryField before;
        RandomFields random(seed);
        visit_fields(random, before);
        before.text = "umlaut ü, \"quoted\"\n";
        const std::string text = json_text(written(before));
        const EveryField after = read(parse_json(text, "x.json"));
        EXPECT_TRUE(same_bits(before, after)) << seed << "\n" << text;
        EXPECT_EQ(json_text(written(after)), text);
    }
}

TEST(FieldsJson, AnyFloatReadsBackToItsBits) {
    std::uint64_t state = 7;
    for (int i = 0; i < 200000; ++i) {
        state = hash_mix(state, 1);
        const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(state));
        if (!std::isfinite(value)) continue;
        const double number = json::parse(json(shortest_double(value)).dump()).get<double>();
        ASSERT_EQ(std::bit_cast<std::uint32_t>(static_cast<float>(number)),
                  std::bit_cast<std::uint32_t>(value));
    }
}

TEST(FieldsJson, FloatsAreShort) {
    EXPECT_EQ(written({}).at("strength").dump(), "0.3");
    EXPECT_EQ(written({}).at("pair").dump(), "[0.1,0.2]");
    EXPECT_EQ(written({}).at("brightness").dump(), "100");
    EXPECT_EQ(written({}).at("rotation").dump(), "[0,0,0,1]");
    EveryField negative_zero;
    negative_zero.open = -0.0f;
    EXPECT_EQ(written(negative_zero).at("open").dump(), "-0.0");
    EXPECT_EQ(json(shortest_double(1.0e-45f)).dump(), "1e-45");
    EXPECT_EQ(json(shortest_double(-0.0f)).dump(), "-0.0");
}

TEST(FieldsJson, KeysKeepTheOrderOfTheFields) {
    EXPECT_EQ(written({}).begin().key(), "flag");
    EXPECT_EQ(std::prev(written({}).end()).key(), "mood");
}

TEST(FieldsJson, AbsentKeysLeaveFieldsAlone) {
    EXPECT_TRUE(same_bits(read(json::object()), EveryField{}));
}

TEST(FieldsJson, TheLimitItselfIsInside) {
    // 0.7 as float is below, 1.5533 as float above the decimal number.
    EXPECT_EQ(read({{"strength", 0.7}}).strength, 0.7f);
    EXPECT_EQ(read({{"angle", 1.5533}}).angle, 1.5533f);
    EXPECT_EQ(read({{"size", 1024.0}}).size, 1024u);
}

TEST(FieldsJson, ErrorsNamePlaceAndRange) {
    EXPECT_EQ(error_for(R"({"angle": 3})"), "x.json: /a/angle: is 3, must be 0.001 to 1.5533 rad");
    EXPECT_EQ(error_for(R"({"precise": -1})"), "x.json: /a/precise: is -1, must be at least 0 m");
    EXPECT_EQ(error_for(R"({"pair": [1, 6]})"), "x.json: /a/pair: is 6, must be at most 5");
    EXPECT_EQ(error_for(R"({"open": 1e39})"), "x.json: /a/open: is 1e+39, must be finite");
    EXPECT_EQ(error_for(R"({"size": 2.5})"),
              "x.json: /a/size: is 2.5, must be a whole number, 4 to 1024 texels");
    EXPECT_EQ(error_for(R"({"size": -1})"), "x.json: /a/size: is -1, must be 4 to 1024 texels");
    EXPECT_EQ(error_for(R"({"steps": 18446744073709551615})"),
              "x.json: /a/steps: is 1.8446744073709552e+19, must be -10 to 10");
}

TEST(FieldsJson, ErrorsNameTheType) {
    EXPECT_EQ(error_for(R"({"flag": 1})"), "x.json: /a/flag: must be true or false, not number");
    EXPECT_EQ(error_for(R"({"size": "64"})"), "x.json: /a/size: must be a number, not string");
    EXPECT_EQ(error_for(R"({"size": null})"), "x.json: /a/size: must be a number, not null");
    EXPECT_EQ(error_for(R"({"colour": 1})"), "x.json: /a/colour: must be an array of 3 numbers, not number");
    EXPECT_EQ(error_for(R"({"colour": [1, 1]})"),
              "x.json: /a/colour: must be an array of 3 numbers, not of 2");
    EXPECT_EQ(error_for(R"({"colour": [1, true, 1]})"), "x.json: /a/colour/1: must be a number, not boolean");
    EXPECT_EQ(error_for(R"({"text": 4})"), "x.json: /a/text: must be a text, not number");
    EXPECT_EQ(error_for("[]"), "x.json: /a: must be an object {…}, not array");
}

TEST(FieldsJson, ErrorsGuessTheSpelling) {
    EXPECT_EQ(
        error_for(R"({"mood": "strmy"})"),
        "x.json: /a/mood: there is no choice 'strmy'; did you mean 'stormy'? Known: calm, windy, stormy");
    const std::string unknown = error_for(R"({"colors": [1, 1, 1]})");
    EXPECT_TRUE(unknown.starts_with(
        "x.json: /a: there is no field 'colors'; did you mean 'colour'? Known: flag, steps"))
        << unknown;
}

TEST(FieldsJson, RotationsAreMadeUnit) {
    const quat turned = read(json::parse(R"({"rotation": [0, 0.7, 0, 0.7]})")).rotation;
    EXPECT_NEAR(glm::length(turned), 1.0f, 1e-6f);
    EXPECT_NEAR(turned.y, 0.70710678f, 1e-6f);
    EXPECT_EQ(
        error_for(R"({"rotation": [0, 0, 0, 0]})"),
        "x.json: /a/rotation: x, y, z, w = 0, 0, 0, 0 is no rotation, because its length cannot be made 1");
    EXPECT_NE(error_for(R"({"rotation": [1e200, 1e200, 0, 0]})"), "");
}

TEST(FieldsJson, NotFiniteIsRefused) {
    EXPECT_NE(error_of([] { read({{"open", std::numeric_limits<double>::quiet_NaN()}}); }), "");
    EXPECT_NE(error_of([] { read({{"precise", std::numeric_limits<double>::infinity()}}); }), "");
}

TEST(FieldsJson, WhatIsWrittenCanBeRead) {
    EveryField broken;
    broken.strength = std::numeric_limits<float>::quiet_NaN();
    broken.open = std::numeric_limits<float>::infinity();
    broken.angle = 9.0f;
    broken.rotation = quat(0, 0, 0, 0);
    broken.size = 0;
    broken.mood = static_cast<EveryField::Mood>(77);
    const EveryField after = read(json::parse(written(broken).dump()));
    EXPECT_EQ(after.strength, 0.0f);
    EXPECT_EQ(after.open, std::numeric_limits<float>::max());
    EXPECT_EQ(after.angle, 1.5533f);
    EXPECT_EQ(after.rotation, quat(1, 0, 0, 0));
    EXPECT_EQ(after.size, 4u);
    EXPECT_EQ(after.mood, EveryField::Mood::stormy);
}

}  // namespace
}  // namespace sl
