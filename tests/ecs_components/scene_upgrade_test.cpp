// SPDX-License-Identifier: MIT
#include "engine/ecs/scene_upgrade.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/ecs/scene_document.h"
#include "tests/ecs_components/scene_folder.h"

namespace sl {
namespace {

using nlohmann::json;

// Made up: what was called "things" is called "nodes" in version 2 and "entities" in version 3, which counts their names from 1.
void rename(json& file, const char* from, const char* to) {
    if (!file.contains(from)) return;
    file[to] = file[from];
    file.erase(from);
}
void things_to_nodes(json& file) { rename(file, "things", "nodes"); }
void nodes_to_entities(json& file) {
    rename(file, "nodes", "entities");
    if (!file.contains("entities") || !file["entities"].is_array()) return;
    for (json& entity : file["entities"]) {
        if (entity.is_object() && entity.contains("name") && entity["name"].is_number()) entity["name"] = fmt::format("{}", entity["name"].get<int>() + 1);
    }
}
constexpr std::array<SceneUpgrade, 2> steps{&things_to_nodes, &nodes_to_entities};

class SceneUpgrades : public SceneFolder {
  protected:
    std::string error_of_version(const std::string& version) {
        json file = json::parse(R"({"secondlight_scene": )" + version + "}");
        try {
            upgrade_scene(file, "s.json", steps);
        } catch (const Error& error) {
            return error.what();
        }
        return file["secondlight_scene"] == 3 ? "" : "is not the newest";
    }
};

TEST_F(SceneUpgrades, EveryVersionBecomesTheNewest) {
    for (const char* text : {R"({"secondlight_scene": 1, "things": [{"name": 6}]})", R"({"secondlight_scene": 2, "nodes": [{"name": 6}]})",
                             R"({"secondlight_scene": 3, "entities": [{"name": "7"}]})"}) {
        json file = json::parse(text);
        upgrade_scene(file, "s.json", steps);
        EXPECT_EQ(file, json::parse(R"({"secondlight_scene": 3, "entities": [{"name": "7"}]})")) << text;
    }
}

TEST_F(SceneUpgrades, FilesOfAnyVersionIncludeEachOther) {
    put("old.json", R"({"secondlight_scene": 1, "things": [{"name": 1}, {"name": 2}]})");
    put("middle.json", R"({"secondlight_scene": 3, "include": "old.json", "entities": [{"name": "2", "remove": true}]})");
    put("s.json", R"({"secondlight_scene": 2, "include": "middle.json", "nodes": [{"name": 5}]})");
    const SceneDocument document = read_scene_document(folder / "s.json", steps);
    std::vector<std::string> names;
    for (const SceneEntity& entity : document.entities) names.emplace_back(entity.name);
    EXPECT_THAT(names, testing::ElementsAre("3", "6"));
    EXPECT_EQ(document.paths, (std::vector{folder / "s.json", folder / "middle.json", folder / "old.json"}));
}

TEST_F(SceneUpgrades, OtherVersionsAreRefused) {
    EXPECT_EQ(error_of_version("1"), "");
    EXPECT_EQ(error_of_version("3.0"), "");
    EXPECT_EQ(error_of_version("4"), "s.json: /secondlight_scene: is 4, but this program knows versions up to 3; open the file with a newer one");
    EXPECT_EQ(error_of_version("1e30"), "s.json: /secondlight_scene: is 1e+30, but this program knows versions up to 3; open the file with a newer one");
    for (const char* version : {"0", "-1", "1.5", "\"1\"", "true", "null", "[1]", "{}"}) {
        EXPECT_EQ(error_of_version(version), fmt::format("s.json: /secondlight_scene: is {}, must be a whole number, at least 1", version));
    }
    json none = json::parse(R"({"scene": 1})");
    EXPECT_THROW(upgrade_scene(none, "s.json", steps), Error);
}

TEST_F(SceneUpgrades, WhatAStepDoesNotUnderstandIsLeftToTheReader) {
    put("s.json", R"({"secondlight_scene": 1, "things": "none"})");
    try {
        read_scene_document(folder / "s.json", steps);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(without_folder(error.what()), "s.json: /entities: must be an array […], not string");
    }
}

}  // namespace
}  // namespace sl
