// SPDX-License-Identifier: MIT
#include "engine/core/json_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "tests/core/every_field.h"

namespace sl {
namespace {

using nlohmann::ordered_json;

std::string error_for(std::string_view text) {
    return error_of([&] { parse_json(text, "x.json"); });
}

TEST(JsonText, ErrorsNameLineAndColumn) {
    EXPECT_EQ(error_for("{\n  \"a\": 1,\n  b\n}"),
              "x.json:3:3: syntax error while parsing object key - invalid literal; last read: '1,<U+000A>  b'; "
              "expected string "
              "literal");
    EXPECT_TRUE(error_for("").starts_with("x.json:1:1: ")) << error_for("");
    EXPECT_TRUE(error_for("[1, 2").starts_with("x.json:1:6: ")) << error_for("[1, 2");
    EXPECT_EQ(error_for("[1,\n 1e999]"), "x.json:2:2: number overflow parsing '1e999'");
}

TEST(JsonText, RefusesRepeatedKeys) {
    EXPECT_EQ(error_for(R"({"a": {"b": 1, "b": 2}})"), "x.json: an object has the key 'b' twice");
    EXPECT_EQ(error_for(R"([{"a": 1}, {"a": {"a": 1}}])"), "");
}

TEST(JsonText, RefusesDeepNesting) {
    const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
    EXPECT_EQ(error_for(nested(64)), "");
    EXPECT_EQ(error_for(nested(65)), "x.json:1:65: nested deeper than 64 levels");
    EXPECT_EQ(error_for(std::string(10'000'000, '[')), "x.json:1:65: nested deeper than 64 levels");
    const std::string brackets(100, '[');
    EXPECT_EQ(error_for(fmt::format(R"("{}\"{}")", brackets, brackets)), "");
}

TEST(JsonText, CommentsAreBlankedOutWhereTheyStand) {
    EXPECT_EQ(without_comments("{ // \"one\n\"a\": /* [{ \n */ 1}"), fmt::format("{{{:8}\n\"a\":{:7}\n{:4}1}}", "", "", ""));
    EXPECT_EQ(without_comments("1 // end"), "1       ");
    EXPECT_EQ(without_comments("/**/1/*/*/2/***/3"), "    1     2     3");
    for (const char* text : {"", "/", "{\"a\": \"// no\"}", R"(["\\\"/* no */", 1])", "1 / 2", "*/", "/*", "/* no end *"}) EXPECT_EQ(without_comments(text), text);
    EXPECT_EQ(error_of([] { parse_json(without_comments("[1, /* two\n lines */ x]"), "x.json"); }).substr(0, 12), "x.json:2:11:");
    EXPECT_TRUE(error_of([] { parse_json(without_comments("[1 /* ]"), "x.json"); }).starts_with("x.json:1:4: "));
}

TEST(JsonText, CommentsAreWhatTheLibraryTakesForThem) {
    constexpr std::string_view bytes = "\"\\/*\n a1,[]{}:";
    std::mt19937 random(1);
    std::size_t documents = 0;
    for (int round = 0; round < 100'000; ++round) {
        std::string text(random() % 24, ' ');
        for (char& c : text) c = bytes[random() % bytes.size()];
        const auto theirs = ordered_json::parse(text, nullptr, false, true), ours = ordered_json::parse(without_comments(text), nullptr, false);
        ASSERT_EQ(ours.is_discarded(), theirs.is_discarded()) << text;
        if (theirs.is_discarded()) continue;
        ASSERT_EQ(ours, theirs) << text;
        ++documents;
    }
    EXPECT_GT(documents, 500u);
}

TEST(JsonText, ACommentHidesNoDepth) {
    const std::string nested(100, '[');
    EXPECT_EQ(error_of([&] { parse_json(without_comments("// \"\n" + nested), "x.json"); }), "x.json:2:65: nested deeper than 64 levels");
}

TEST(JsonText, RefusesWhatStandsBehindAZero) {
    EXPECT_EQ(error_for(std::string_view("[1]\0[2]", 7)), "x.json:1:4: a zero byte stands in it");
}

TEST(JsonText, BuildsWhatStandsThere) {
    const auto read = parse_json(R"({"a": [1, -2, 0.5, null, true, [], {}, "x\ny"], "b": {"c": {"d": [[3]]}, "e": false}})", "x.json");
    EXPECT_EQ(read, nlohmann::json::parse(R"({"a": [1, -2, 0.5, null, true, [], {}, "x\ny"], "b": {"c": {"d": [[3]]}, "e": false}})"));
    EXPECT_TRUE(read["a"][0].is_number_unsigned());
    EXPECT_EQ(parse_json(" 7 ", "x.json"), 7);
}

TEST(JsonText, LongArraysTakeTimeInProportion) {
    std::string text = "[{}";
    for (int i = 1; i < 1'000'000; ++i) text += ",{}";
    EXPECT_EQ(parse_json(text + "]", "x.json").size(), 1'000'000u);
}

TEST(JsonText, MessagesStayOnOneShortLine) {
    const std::string message = error_for(fmt::format("{{\"{}", std::string(1'000'000, '\x01')));
    EXPECT_LT(message.size(), 400u);
    EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST(JsonText, WritesSmallThingsOnOneLine) {
    const ordered_json value = {{"z", 1}, {"list", {{{"name", "ü"}, {"at", {1.0, 0.5}}}, {{"name", "b"}}}}};
    EXPECT_EQ(json_text(value), R"({
  "z": 1,
  "list": [
    {"name": "ü", "at": [1.0, 0.5]},
    {"name": "b"}
  ]
}
)");
    EXPECT_EQ(json_text(ordered_json::array()), "[]\n");
    EXPECT_EQ(json_text(ordered_json::object()), "{}\n");
}

TEST(JsonText, LongThingsAreBroken) {
    ordered_json value = ordered_json::array();
    for (int i = 0; i < 60; ++i) value.push_back(i);
    EXPECT_TRUE(json_text(value).starts_with("[\n  0,\n  1,")) << json_text(value);
    EXPECT_EQ(ordered_json::parse(json_text(value)), value);
}

TEST(JsonText, BrokenUtf8IsReplaced) {
    EXPECT_EQ(json_text(ordered_json("a\xff")), "\"a\xef\xbf\xbd\"\n");
}

}  // namespace
}  // namespace sl
