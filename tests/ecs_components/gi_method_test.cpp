// SPDX-License-Identifier: MIT
#include "engine/ecs/components/gi_method.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/core/fields_json.h"
#include "engine/ecs/components/gi_settings.h"

namespace sl {
namespace {

/// A method that the engine does not have.
struct Glow {
    static constexpr std::string_view name = "glow";
    static constexpr std::string_view claims = "the same light everywhere";
    float lux = 10.0f;
};
void visit_fields(FieldVisitor& visit, Glow& glow) { visit.field("lux", glow.lux, {.min = 0, .max = 100, .help = "More is brighter."}); }

/// One that nobody adds.
struct Unknown {
    static constexpr std::string_view name = "unknown";
    static constexpr std::string_view claims = "nothing";
};
void visit_fields(FieldVisitor&, Unknown&) {}

GiSettings read(const nlohmann::json& object) {
    GiSettings settings;
    JsonReader reader(object, "x.json: /gi");
    visit_fields(reader, settings);
    reader.check_all_used();
    return settings;
}

TEST(GiMethodTest, IsAValue) {
    GiMethod one = RsmGrid{.step = 3};
    const GiMethod another = one;
    one.get<RsmGrid>().step = 5;
    EXPECT_EQ(another.get<RsmGrid>().step, 3u);
    EXPECT_EQ(one.get<RsmGrid>().step, 5u);
    EXPECT_TRUE(one.is<RsmGrid>());
    EXPECT_EQ(one.get_if<RsmDisc>(), nullptr);
    one = GiOff{};
    EXPECT_EQ(one.name(), "off");
    EXPECT_EQ(one.claims(), GiOff::claims);
}

TEST(GiMethodTest, TheEnginesMethodsAreKnownByName) {
    for (const std::string_view name : gi_method_names()) {
        const GiMethod method = make_gi_method(name);
        EXPECT_EQ(method.name(), name);
        EXPECT_EQ(gi_method_names()[gi_method_index(method)], name);
    }
    EXPECT_EQ(gi_method_names().front(), "off");
    EXPECT_THROW(make_gi_method("radiosity"), Error);
}

/// Adds Glow and exits: with 0 where it is then read and written like the engine's.
[[noreturn]] void add_glow() {
    add_gi_method_type(GiMethod::type_of<Glow>());
    GiSettings settings = read({{"method", "glow"}, {"lux", 25}});
    nlohmann::ordered_json written;
    JsonWriter writer(written);
    visit_fields(writer, settings);
    const bool right = gi_method_names().back() == "glow" && settings.method.get<Glow>().lux == 25.0f &&
                       written == nlohmann::ordered_json({{"method", "glow"}, {"lux", 25}});
    fmt::print(stderr, "{}", written.dump());
    std::_Exit(right ? 0 : 1);  // without waiting for threads that a forked process has not
}

// A method stays for as long as the program runs, so each of these runs in one of its own.
TEST(GiMethodTest, AnAddedOneIsReadAndWrittenLikeTheEngines) {
    EXPECT_THROW(read({{"method", "glow"}}), Error);
    EXPECT_EXIT(add_glow(), testing::ExitedWithCode(0), "glow");
    EXPECT_DEATH((add_gi_method_type(GiMethod::type_of<Glow>()), add_gi_method_type(GiMethod::type_of<Glow>())), "two GI methods are called 'glow'");
}

TEST(GiMethodTest, MistakesStop) {
    GiMethod off = GiOff{};
    EXPECT_DEATH(off.get<RsmDisc>(), "the GI method is off, not rsm_disc");
    EXPECT_DEATH(gi_method_index(Unknown{}), "the GI method 'unknown' is in use and was not added");
}

}  // namespace
}  // namespace sl
