// SPDX-License-Identifier: MIT
#include "engine/ecs/scene_file.h"

#include <gmock/gmock.h>

#include "engine/ecs/parent.h"
#include "tests/ecs_components/scene_folder.h"
#include "tests/support/random_scene.h"

namespace sl {
namespace {

namespace fs = std::filesystem;
using SceneFile = SceneFolder;

TEST_F(SceneFile, ReadsEntitiesComponentsAndParents) {
    put("s.json", R"({"secondlight_scene": 1, "description": "Two lamps",
        "entities": [
            {"name": "lamp", "parent": "house", "transform": {"translation": [1000000.125, 0, 0]},
             "spot_light": {"outer_cone": 0.5}},
            {"name": "house", "transform": {}},
            {"name": "view", "camera": {"fov_y": 1}, "gi": {"method": "rsm_grid", "strength": 0.6, "step": 2}}
        ]})");
    read("s.json");
    EXPECT_EQ(world.entity_count(), 3u);
    EXPECT_EQ(world.get<Parent>(named("lamp")).entity, named("house"));
    EXPECT_EQ(world.get<Transform>(named("lamp")).translation.x, 1000000.125);
    EXPECT_EQ(world.get<SpotLight>(named("lamp")).outer_cone, 0.5f);
    EXPECT_EQ(world.get<SpotLight>(named("lamp")).intensity, SpotLight().intensity);
    EXPECT_EQ(world.get<GiSettings>(named("view")).method.get<RsmGrid>().step, 2u);
    EXPECT_EQ(world.resource<SceneInfo>().description, "Two lamps");
    EXPECT_EQ(world.resource<SceneInfo>().path, folder / "s.json");
}

TEST_F(SceneFile, WriteReadWriteIsIdentity) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        World before, after;
        fill_randomly(before, registry, seed);
        before.add_resource(SceneInfo{.description = "a \\ description", .path = folder / "none.json", .schema = "../a schema.json"});
        write_scene(before, registry, folder / "a.json");
        read_scene(after, registry, folder / "a.json");
        ASSERT_EQ(told(after, registry), told(before, registry)) << seed;
        write_scene(after, registry, folder / "b.json");
        ASSERT_EQ(text_of("a.json"), text_of("b.json")) << seed;
    }
}

TEST_F(SceneFile, FilesAreFoundFromAnotherFolder) {
    fs::create_directories(folder / "one" / "parts");
    fs::create_directories(folder / "two" / "deep");
    put("one/parts/base.json", R"({"secondlight_scene": 1, "$schema": "no.json", "entities": [
        {"name": "inner", "model": {"file": "../inner.glb"}}, {"name": "outer", "model": {"file": "replaced.glb"}}]})");
    put("one/s.json", R"({"secondlight_scene": 1, "$schema": "scene.json", "include": "parts/base.json", "entities": [
        {"name": "outer", "model": {"file": "parts/../outer.glb"}}, {"name": "full", "model": {"file": "/full.glb"}}, {"name": "none", "model": {}}]})");
    const auto files = [&] {
        std::vector<std::string> found;
        for (const char* name : {"inner", "outer", "full", "none"}) found.push_back(world.get<ModelFile>(named(name)).file);
        return found;
    };
    read("one/s.json");
    EXPECT_THAT(files(), testing::ElementsAre("inner.glb", "parts/../outer.glb", "/full.glb", ""));
    write_scene(world, registry, folder / "two" / "deep" / "s.json");
    world.clear();
    read("two/deep/s.json");
    EXPECT_THAT(files(), testing::ElementsAre("../../one/inner.glb", "../../one/outer.glb", "/full.glb", ""));
    EXPECT_EQ(world.resource<SceneInfo>().schema, "../../one/scene.json");
    // Through a link, ".." leads elsewhere than the letters say.
    fs::create_directory_symlink("two/deep", folder / "link");
    write_scene(world, registry, folder / "link" / "t.json");
    EXPECT_EQ(text_of("two/deep/t.json"), text_of("two/deep/s.json"));
    write_scene(world, registry, folder / "one" / "t.json");
    world.clear();
    read("one/t.json");
    EXPECT_THAT(files(), testing::ElementsAre("inner.glb", "outer.glb", "/full.glb", ""));
    EXPECT_EQ(world.resource<SceneInfo>().schema, "scene.json");
}

TEST_F(SceneFile, ASchemaOnTheWebKeepsItsPlace) {
    put("s.json", R"({"$schema": "https://example.org/scene.json", "secondlight_scene": 1})");
    read("s.json");
    fs::create_directory(folder / "in");
    write_scene(world, registry, folder / "in" / "s.json");
    EXPECT_EQ(text_of("in/s.json"), "{\"$schema\": \"https://example.org/scene.json\", \"secondlight_scene\": 1, \"entities\": []}\n");
}

TEST_F(SceneFile, IsForPeopleToRead) {
    world.create(Name{"sun"}, SunAngles{}, Transform{});
    world.create(Name{"view"}, GiSettings{GiOff{}});
    write_scene(world, registry, folder / "s.json");
    EXPECT_EQ(text_of("s.json"), R"({
  "secondlight_scene": 1,
  "entities": [
    {
      "name": "sun",
      "transform": {"translation": [0, 0, 0], "rotation": [0, 0, 0, 1], "scale": [1, 1, 1]},
      "sun": {"azimuth": 0.6, "elevation": 0.9}
    },
    {
      "name": "view",
      "gi": {"method": "off"}
    }
  ]
}
)");
}

TEST_F(SceneFile, OnlyNamedEntitiesAreWritten) {
    world.create(Transform{});
    world.create(Name{"a"}, WorldTransform{});
    write_scene(world, registry, folder / "s.json");
    World other;
    read_scene(other, registry, folder / "s.json");
    EXPECT_EQ(other.entity_count(), 1u);
}

TEST_F(SceneFile, OrderSurvivesClearingAndReadingAgain) {
    put("s.json", R"({"secondlight_scene": 1, "entities": [{"name": "c"}, {"name": "a"}, {"name": "b"}]})");
    read("s.json");
    write_scene(world, registry, folder / "first.json");
    world.clear();
    read("first.json");
    write_scene(world, registry, folder / "second.json");
    EXPECT_EQ(text_of("first.json"), text_of("second.json"));
}

TEST_F(SceneFile, RefusesToWriteWhatCannotBeRead) {
    put("s.json", "precious");
    const auto error = [&] {
        try {
            write_scene(world, registry, folder / "s.json");
        } catch (const std::exception& thrown) {
            return without_folder(thrown.what());
        }
        return std::string();
    };
    const Entity first = world.create(Name{"a"}), second = world.create(Name{"a"});
    EXPECT_EQ(error(), "s.json: not written, because two entities are called 'a'; rename one");
    world.get<Name>(second).value = "";
    EXPECT_EQ(error(), "s.json: not written, because an entity has an empty name; name it");
    world.get<Name>(second).value = "b";
    world.add(first, Parent{world.create()});
    EXPECT_EQ(error(), "s.json: not written, because the parent of 'a' has no name; give it one");
    EXPECT_EQ(text_of("s.json"), "precious");
    world.destroy(world.get<Parent>(first).entity);
    EXPECT_EQ(error(), "");
}

TEST_F(SceneFile, AnErrorLeavesTheWorldAsItWas) {
    put("good.json",
        R"({"secondlight_scene": 1, "description": "good", "entities": [{"name": "a", "camera": {}}]})");
    put("bad.json",
        R"({"secondlight_scene": 1, "entities": [{"name": "b"}, {"name": "c", "camera": {"near": -1}}]})");
    read("good.json");
    EXPECT_EQ(error_of_reading("bad.json"),
              "bad.json: /entities/1/camera/near: is -1, must be 1e-06 to 1000 m");
    EXPECT_EQ(world.entity_count(), 1u);
    EXPECT_EQ(world.resource<SceneInfo>().description, "good");
}

TEST_F(SceneFile, IncludedEntitiesAreMergedByName) {
    put("parts/base.json", R"({"secondlight_scene": 1, "description": "base", "entities": [
        {"name": "sun", "sun": {"azimuth": 1, "elevation": 0.5}, "directional_light": {}},
        {"name": "tree", "shape": {}},
        {"name": "view", "gi": {"method": "rsm_grid", "step": 4}, "parent": "tree"}]})");
    put("parts/middle.json", R"({"secondlight_scene": 1, "include": "base.json", "entities": [
        {"name": "sun", "directional_light": null, "sun": {"elevation": 0.25}}]})");
    put("s.json", R"({"secondlight_scene": 1, "include": "parts/middle.json", "entities": [
        {"name": "tree", "remove": true}, {"name": "new", "shape": {"kind": "disc"}},
        {"name": "view", "parent": null, "gi": {"method": "rsm_disc"}}]})");
    read("s.json");
    EXPECT_EQ(world.entity_count(), 3u);
    EXPECT_EQ(world.get<SunAngles>(named("sun")).azimuth, 1.0f);
    EXPECT_EQ(world.get<SunAngles>(named("sun")).elevation, 0.25f);
    EXPECT_FALSE(world.has<DirectionalLight>(named("sun")));
    EXPECT_FALSE(named("tree"));
    EXPECT_FALSE(world.has<Parent>(named("view")));
    EXPECT_EQ(world.get<GiSettings>(named("view")).method.name(), "rsm_disc");
    EXPECT_EQ(world.resource<SceneInfo>().description, "");
}

TEST_F(SceneFile, ErrorsInAnIncludedFileNameThatFile) {
    put("base.json", R"({"secondlight_scene": 1, "entities": [{"name": "a", "shape": {"size": [1, 1]}}]})");
    put("s.json",
        R"({"secondlight_scene": 1, "include": "base.json", "entities": [{"name": "a", "shape": {}}]})");
    EXPECT_EQ(error_of_reading("s.json"),
              "base.json: /entities/0/shape/size: must be an array of 3 numbers, not of 2");
}

}  // namespace
}  // namespace sl
