// SPDX-License-Identifier: MIT
#include "engine/ecs/scene_schema.h"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/core/json_text.h"
#include "engine/core/text_file.h"
#include "engine/ecs/scene_document.h"
#include "engine/ecs/scene_file.h"
#include "game/session.h"
#include "tests/support/random_scene.h"

namespace sl {
namespace {

namespace fs = std::filesystem;

const fs::path source(SL_SOURCE_FOLDER);
const fs::path published = source / "docs/scene.schema.json";

/// Scene files that a validator of JSON Schema is asked about.
class SceneSchema : public testing::Test {
  protected:
    SceneSchema() : app(empty_game()) {
        folder = fs::temp_directory_path() / fmt::format("sl_schema_{}_{}", testing::UnitTest::GetInstance()->current_test_info()->name(), ::getpid());
        fs::create_directories(folder);
    }
    ~SceneSchema() override { fs::remove_all(folder); }

    void put(const std::string& name, const std::string& text) const { write_text_file(folder / name, text); }
    void put(const std::vector<const char*>& scenes) const {
        for (std::size_t i = 0; i < scenes.size(); ++i) put(fmt::format("{:03}.json", i), scenes[i]);
    }

    /// The files in the folder that the published schema refuses, and why; nothing where there is no validator.
    std::optional<std::map<std::string, std::string>> refused() const {
        const std::string command =
            fmt::format("'{}' -B '{}' '{}' '{}'", SL_PYTHON, (source / "tests/game/validate_scenes.py").string(), published.string(), folder.string());
        std::FILE* output = ::popen(command.c_str(), "r");
        std::string text;
        for (int c = std::fgetc(output); c != EOF; c = std::fgetc(output)) text += static_cast<char>(c);
        const int status = ::pclose(output);
        if (WIFEXITED(status) && WEXITSTATUS(status) == 77) return std::nullopt;
        EXPECT_EQ(status, 0) << command;
        std::map<std::string, std::string> reasons;
        std::istringstream lines(text);
        for (std::string name, reason; std::getline(lines, name, '\t') && std::getline(lines, reason);) reasons[name] = reason;
        return reasons;
    }
    /// What the reader says; empty where it takes the scene.
    std::string error_of_reading(const fs::path& file) {
        try {
            read_scene(app.world, app.registry(), file);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }

    fs::path folder;
    App app;
};

constexpr const char* no_validator = "there is no validator: install python3-jsonschema";

TEST_F(SceneSchema, TheOneInDocsIsOfThisProgram) {
    EXPECT_TRUE(read_text_file(published, most_scene_bytes) == json_text(scene_schema(app.registry())))
        << "docs/scene.schema.json is not what the components say; renew it: ./play schema -o docs/scene.schema.json";
}

TEST_F(SceneSchema, ScenesOfTheGameSatisfyIt) {
    std::size_t scenes = 0;
    for (const auto& entry : fs::directory_iterator(source / "game/scenes")) {
        put(entry.path().filename(), without_comments(read_text_file(entry.path(), most_scene_bytes)));
        ++scenes;
    }
    EXPECT_GT(scenes, 5u);
    const auto reasons = refused();
    if (!reasons) GTEST_SKIP() << no_validator;
    EXPECT_THAT(*reasons, testing::IsEmpty());
}

TEST_F(SceneSchema, TheExampleInTheReadmeSatisfiesItAndIsRead) {
    const std::string readme = read_text_file(source / "README.md", most_scene_bytes), fence = "```json\n";
    const std::size_t start = readme.find(fence) + fence.size();
    put("example.json", without_comments(readme.substr(start, readme.find("```", start) - start)));
    put("village.json", read_text_file(source / "game/scenes/village.json", most_scene_bytes));
    EXPECT_EQ(error_of_reading(folder / "example.json"), "");
    const auto reasons = refused();
    if (!reasons) GTEST_SKIP() << no_validator;
    EXPECT_THAT(*reasons, testing::IsEmpty());
}

TEST_F(SceneSchema, WrittenScenesSatisfyItAndAreReadAsTheyWere) {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        World before, after;
        fill_randomly(before, app.registry(), seed);
        before.add_resource(SceneInfo{.description = "ü", .path = folder / "none.json", .schema = "scene.schema.json"});
        const std::string file = fmt::format("{}.json", seed);
        write_scene(before, app.registry(), folder / file);
        read_scene(after, app.registry(), folder / file);
        ASSERT_EQ(told(after, app.registry()), told(before, app.registry())) << seed;
        write_scene(after, app.registry(), folder / "again.json");
        ASSERT_EQ(read_text_file(folder / "again.json", most_scene_bytes), read_text_file(folder / file, most_scene_bytes)) << seed;
    }
    const auto reasons = refused();
    if (!reasons) GTEST_SKIP() << no_validator;
    EXPECT_THAT(*reasons, testing::IsEmpty());
}

TEST_F(SceneSchema, ItAndTheReaderTakeTheSameScenes) {
    put({R"({"secondlight_scene": 1})",
         R"({"secondlight_scene": 1.0, "entities": [], "$schema": "", "description": ""})",
         R"({"secondlight_scene": 1, "entities": [{"name": "a"}, {"name": "b", "parent": "a", "camera": null, "gi": null}, {"name": "c", "parent": null, "remove": false}]})",
         R"({"secondlight_scene": 1, "include": "000.json", "entities": [{"name": "a", "camera": {}, "transform": {"translation": [1e7, -1e7, 0.5]}}]})",
         R"({"secondlight_scene": 1, "entities": [{"name": "a", "gi": {"method": "rsm_grid", "step": 2.0, "preset": "paper"}, "spot_light": {"outer_cone": 1.5533}}]})",
         R"({"secondlight_scene": 1, "entities": [{"name": "a", "model": {"file": "ship.glb", "scene": -1}, "voxels": {"seed": 4294967295}}]})"});
    for (const auto& entry : fs::directory_iterator(folder)) EXPECT_EQ(error_of_reading(entry.path()), "");
    const auto reasons = refused();
    if (!reasons) GTEST_SKIP() << no_validator;
    EXPECT_THAT(*reasons, testing::IsEmpty());
}

TEST_F(SceneSchema, ItAndTheReaderRefuseTheSameScenes) {
    const std::vector<const char*> wrong{
        "{}", "[]", "null",
        R"({"secondlight_scene": 0})", R"({"secondlight_scene": 2})", R"({"secondlight_scene": "1"})", R"({"secondlight_scene": 1.5})", R"({"secondlight_scene": null})",
        R"({"secondlight_scene": 1, "entitys": []})", R"({"secondlight_scene": 1, "entities": {}})", R"({"secondlight_scene": 1, "entities": null})",
        R"({"secondlight_scene": 1, "description": 1})", R"({"secondlight_scene": 1, "include": ["a.json"]})", R"({"secondlight_scene": 1, "include": ""})",
        R"({"secondlight_scene": 1, "$schema": null})"};
    const std::vector<const char*> wrong_entities{
        "null", "[]", "{}", R"({"name": ""})", R"({"name": 1})", R"({"name": "a", "parent": ""})", R"({"name": "a", "parent": 1})",
        R"({"name": "a", "remove": 1})", R"({"name": "a", "remove": true, "camera": {}})", R"({"name": "a", "lamp": {}})", R"({"name": "a", "lamp": null})",
        R"({"name": "a", "camera": 1})", R"({"name": "a", "camera": []})", R"({"name": "a", "camera": {"fov": 1}})", R"({"name": "a", "camera": {"near": null}})",
        R"({"name": "a", "camera": {"near": "1"}})", R"({"name": "a", "camera": {"near": 0}})", R"({"name": "a", "camera": {"near": [1]}})", R"({"name": "a", "camera": {"active": 1}})",
        R"({"name": "a", "gi": {"method": "rsm_disk"}})", R"({"name": "a", "gi": {"method": "off", "strength": 1}})", R"({"name": "a", "gi": {"method": "rsm_grid", "radius": 1}})",
        R"({"name": "a", "gi": {"method": "rsm_disc", "samples": 0.5}})", R"({"name": "a", "gi": {"method": "rsm_disc", "samples": -1}})", R"({"name": "a", "gi": {"strength": 11}})",
        R"({"name": "a", "transform": {"translation": 1}})", R"({"name": "a", "transform": {"translation": [1, 2]}})", R"({"name": "a", "transform": {"translation": [1, 2, null]}})",
        R"({"name": "a", "transform": {"translation": [1e8, 0, 0]}})", R"({"name": "a", "transform": {"rotation": [0, 0, 1]}})", R"({"name": "a", "shape": {"kind": 0}})",
        R"({"name": "a", "material": {"base_colour": [2, 0, 0]}})", R"({"name": "a", "model": {"file": null}})", R"({"name": "a", "model": {"scene": 1.5}})",
        R"({"name": "a", "voxels": {"generator": "none"}})", R"({"name": "a", "voxels": {"seed": 4294967296}})"};
    put(wrong);
    for (std::size_t i = 0; i < wrong_entities.size(); ++i) {
        put(fmt::format("entity_{:03}.json", i), fmt::format(R"({{"secondlight_scene": 1, "entities": [{}]}})", wrong_entities[i]));
    }
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) {
        names.emplace_back(entry.path().filename());
        EXPECT_THAT(error_of_reading(entry.path()), testing::StartsWith(entry.path().string() + ": ")) << read_text_file(entry.path(), 1000);
    }
    const auto reasons = refused();
    if (!reasons) GTEST_SKIP() << no_validator;
    for (const std::string& name : names) EXPECT_TRUE(reasons->contains(name)) << read_text_file(folder / name, 1000);
}

TEST_F(SceneSchema, WhatItCannotSayIsLeftToTheReader) {
    put({R"({"secondlight_scene": 1, "include": "none.json"})",
         R"({"secondlight_scene": 1, "entities": [{"name": "a"}, {"name": "a"}]})",
         R"({"secondlight_scene": 1, "entities": [{"name": "a", "parent": "b"}]})",
         R"({"secondlight_scene": 1, "entities": [{"name": "a", "remove": true}]})",
         R"({"secondlight_scene": 1, "entities": [{"name": "a", "transform": {"rotation": [0, 0, 0, 0]}}]})"});
    for (const auto& entry : fs::directory_iterator(folder)) EXPECT_NE(error_of_reading(entry.path()), "") << entry.path();
    const auto reasons = refused();
    if (!reasons) GTEST_SKIP() << no_validator;
    EXPECT_THAT(*reasons, testing::IsEmpty());
}

}  // namespace
}  // namespace sl
