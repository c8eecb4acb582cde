// SPDX-License-Identifier: MIT
#include <array>

#include "engine/core/math.h"
#include "engine/ecs/scene_document.h"
#include "tests/ecs_components/scene_folder.h"

namespace sl {
namespace {

using MalformedScenes = SceneFolder;

// Everything that a hand, a crash or a merge can leave behind. None may crash, none may be taken for a scene.
constexpr std::array malformed_files{"",
                                     " ",
                                     "\n\n",
                                     "null",
                                     "true",
                                     "1",
                                     "\"text\"",
                                     "[]",
                                     "[1, 2",
                                     "{",
                                     "}",
                                     "{]",
                                     "[}",
                                     "{\"",
                                     "{\"a",
                                     "{\"a\"",
                                     "{\"a\":",
                                     "{\"a\": 1",
                                     "{\"a\": 1,",
                                     "{\"a\": 1,}",
                                     "{'a': 1}",
                                     "{a: 1}",
                                     "{\"a\" 1}",
                                     "// comment\n{}",
                                     "<html></html>",
                                     "<<<<<<< HEAD",
                                     "\xff\xfe{\0}",
                                     "\x80\x80\x80",
                                     "\"\xc3\"",
                                     "\"\\ud800\"",
                                     "\"\\u12\"",
                                     "\"\\x\"",
                                     "nan",
                                     "[NaN]",
                                     "[Infinity]",
                                     "[-]",
                                     "[01]",
                                     "[1.]",
                                     "[.5]",
                                     "[1e]",
                                     "[1e400]",
                                     "[-1e400]",
                                     "[+1]",
                                     "[0x10]",
                                     "{\"secondlight_scene\": }",
                                     "{\"secondlight_scene\": 0}",
                                     "{\"secondlight_scene\": \"1\"}",
                                     "{\"secondlight_scene\": 1.5}",
                                     "{\"secondlight_scene\": null}",
                                     "{\"secondlight_scene\": [1]}",
                                     "{\"secondlight_scene\": 99999999999999999999999}",
                                     "{\"secondlight_scene\": 1} trailing",
                                     "{\"secondlight_scene\": 1}{}",
                                     "{\"secondlight_scene\": 1, \"secondlight_scene\": 1}",
                                     "{\"secondlight_scene\": 1, \"description\": 1}",
                                     "{\"secondlight_scene\": 1, \"description\": null}",
                                     "{\"secondlight_scene\": 1, \"include\": 1}",
                                     "{\"secondlight_scene\": 1, \"include\": []}",
                                     "{\"secondlight_scene\": 1, \"include\": \"s.json\"}",
                                     "{\"secondlight_scene\": 1, \"include\": \"./s.json\"}",
                                     "{\"secondlight_scene\": 1, \"include\": \"\\u0000\"}",
                                     "{\"secondlight_scene\": 1, \"include\": \"/dev/zero\"}",
                                     "{\"secondlight_scene\": 1, \"entities\": {}}",
                                     "{\"secondlight_scene\": 1, \"entities\": null}",
                                     "{\"secondlight_scene\": 1, \"entities\": 1}",
                                     "{\"secondlight_scene\": 1, \"\": 1}"};

constexpr std::array malformed_entities{
    "[null]",
    "[1]",
    "[[]]",
    "[\"a\"]",
    "[{}]",
    "[{\"name\": 1}]",
    "[{\"name\": null}]",
    "[{\"name\": \"\"}]",
    "[{\"name\": []}]",
    "[{\"Name\": \"a\"}]",
    "[{\"name\": \"a\", \"name\": \"b\"}]",
    "[{\"name\": \"a\", \"\": {}}]",
    "[{\"name\": \"a\", \"parent\": 1}]",
    "[{\"name\": \"a\", \"parent\": \"\"}]",
    "[{\"name\": \"a\", \"parent\": [\"a\"]}]",
    "[{\"name\": \"a\", \"remove\": 1}]",
    "[{\"name\": \"a\", \"remove\": null}]",
    "[{\"name\": \"a\", \"remove\": true, \"camera\": {}}]",
    "[{\"name\": \"a\", \"tree\": {}}]",
    "[{\"name\": \"a\", \"tree\": null}]",
    "[{\"name\": \"a\", \"camera\": 1}]",
    "[{\"name\": \"a\", \"camera\": []}]",
    "[{\"name\": \"a\", \"camera\": true}]",
    "[{\"name\": \"a\", \"camera\": {\"near\": \"1\"}}]",
    "[{\"name\": \"a\", \"camera\": {\"near\": null}}]",
    "[{\"name\": \"a\", \"camera\": {\"near\": [1]}}]",
    "[{\"name\": \"a\", \"camera\": {\"near\": {}}}]",
    "[{\"name\": \"a\", \"camera\": {\"near\": 0}}]",
    "[{\"name\": \"a\", \"camera\": {\"near\": 1e308}}]",
    "[{\"name\": \"a\", \"camera\": {\"active\": 1}}]",
    "[{\"name\": \"a\", \"camera\": {\"active\": \"true\"}}]",
    "[{\"name\": \"a\", \"gi\": {\"method\": 1}}]",
    "[{\"name\": \"a\", \"gi\": {\"method\": \"\"}}]",
    "[{\"name\": \"a\", \"gi\": {\"method\": \"off\", \"strength\": 1}}]",
    "[{\"name\": \"a\", \"gi\": {\"samples\": 1e10}}]",
    "[{\"name\": \"a\", \"gi\": {\"samples\": -1}}]",
    "[{\"name\": \"a\", \"gi\": {\"samples\": 0.5}}]",
    "[{\"name\": \"a\", \"gi\": {\"step\": 1}}]",
    "[{\"name\": \"a\", \"transform\": {\"translation\": 1}}]",
    "[{\"name\": \"a\", \"transform\": {\"translation\": []}}]",
    "[{\"name\": \"a\", \"transform\": {\"translation\": [1, 2, 3, 4]}}]",
    "[{\"name\": \"a\", \"transform\": {\"translation\": [1, 2, null]}}]",
    "[{\"name\": \"a\", \"transform\": {\"translation\": [1e8, 0, 0]}}]",
    "[{\"name\": \"a\", \"transform\": {\"rotation\": [0, 0, 0, 0]}}]",
    "[{\"name\": \"a\", \"transform\": {\"rotation\": [1e308, 1e308, 0, 0]}}]",
    "[{\"name\": \"a\", \"transform\": {\"rotation\": [1, 0, 0]}}]",
    "[{\"name\": \"a\", \"transform\": {\"rotation\": {\"x\": 1}}}]",
    "[{\"name\": \"a\", \"shape\": {\"kind\": \"Box\"}}]",
    "[{\"name\": \"a\", \"shape\": {\"kind\": 0}}]",
    "[{\"name\": \"a\", \"shape\": {\"size\": [1, 1, -1]}}]",
    "[{\"name\": \"a\", \"material\": {\"base_colour\": [2, 0, 0]}}]",
    "[{\"name\": \"a\", \"material\": {\"base_colour\": \"red\"}}]"};

TEST_F(MalformedScenes, FilesAreErrorsAndNothingWorse) {
    for (const char* text : malformed_files) {
        put("s.json", text);
        const std::string message = error_of_reading("s.json");
        EXPECT_TRUE(message.starts_with("s.json")) << text << "\n" << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
    for (const char* entities : malformed_entities) {
        const std::string message = error_of_entities(entities);
        EXPECT_TRUE(message.starts_with("s.json")) << entities << "\n" << message;
    }
    EXPECT_EQ(world.entity_count(), 0u);
}

TEST_F(MalformedScenes, EntitiesOfAllFilesAreCountedFirst) {
    const auto empty = [](std::size_t count) {
        std::string text = "{}";
        for (std::size_t i = 1; i < count; ++i) text += ",{}";
        return text;
    };
    const char* wanted = "s.json: /entities: 131073 entities, with those of included files; 131072 is the limit";
    EXPECT_EQ(error_of_entities("[" + empty(most_scene_entities + 1) + "]"), wanted);
    put("inner.json", R"({"secondlight_scene": 1, "entities": [{"name": "a"}, {"name": "b"}]})");
    put("s.json", R"({"secondlight_scene": 1, "include": "inner.json", "entities": [)" + empty(most_scene_entities - 1) + "]}");
    EXPECT_EQ(error_of_reading("s.json"), wanted);
    EXPECT_EQ(world.entity_count(), 0u);
}

TEST_F(MalformedScenes, ATruncatedOrDamagedFileNeverCrashes) {
    const std::string whole =
        R"({"secondlight_scene": 1, "description": "ü", "entities": [{"name": "a", "parent": "b",
        "transform": {"translation": [1, 2.5e3, -3]}, "gi": {"method": "rsm_disc", "rotate": true}},
        {"name": "b", "camera": null}]})";
    for (std::size_t length = 0; length < whole.size(); ++length) {
        put("s.json", std::string_view(whole).substr(0, length));
        EXPECT_NE(error_of_reading("s.json"), "") << length;
    }
    std::uint64_t state = 1;
    for (int round = 0; round < 3000; ++round) {
        std::string damaged = whole;
        for (int change = 0; change < 3; ++change) {
            state = hash_mix(state, 1);
            constexpr std::string_view bytes = "{}[]\",:0-9etn\\\x01\xff ";
            damaged[state % damaged.size()] = bytes[(state >> 32) % bytes.size()];
        }
        put("s.json", damaged);
        error_of_reading("s.json");
        world.clear();
    }
}

}  // namespace
}  // namespace sl
