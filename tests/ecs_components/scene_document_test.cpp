// SPDX-License-Identifier: MIT
#include "engine/ecs/scene_document.h"

#include "tests/ecs_components/scene_folder.h"

namespace sl {
namespace {

namespace fs = std::filesystem;
using SceneDocuments = SceneFolder;

TEST_F(SceneDocuments, ErrorsSayWhatIsWrong) {
    EXPECT_EQ(error_of_entities(R"([{"name": "a", "spotlight": {}}])"),
              "s.json: /entities/0: there is no component 'spotlight'; did you mean 'spot_light'? Known: "
              "transform, "
              "camera, gi, directional_light, sun, day_cycle, spot_light, point_light, sky, shape, material, model");
    EXPECT_EQ(error_of_entities(R"([{"name": "a", "spot_light": {"outer_cone": 3}}])"),
              "s.json: /entities/0/spot_light/outer_cone: is 3, must be 0.001 to 1.5533 rad");
    EXPECT_EQ(
        error_of_entities(R"([{"name": "a", "camera": {"fov": 1}}])"),
        "s.json: /entities/0/camera: there is no field 'fov'. Known: fov_y, height, near, ev100, auto_exposure, antialias, active");
    EXPECT_EQ(
        error_of_entities(R"([{"name": "a", "gi": {"method": "rsm_disk"}}])"),
        "s.json: /entities/0/gi/method: there is no choice 'rsm_disk'; did you mean 'rsm_disc'? Known: off, "
        "rsm_exact, rsm_grid, rsm_disc, facets");
    EXPECT_EQ(error_of_entities(R"([{"name": "a"}, {"name": "a"}])"),
              "s.json: /entities/1/name: there are two entities called 'a'");
    EXPECT_EQ(error_of_entities(R"([{"name": "a", "parent": "house"}])"),
              "s.json: /entities/0/parent: there is no entity 'house'. Known: a");
    EXPECT_EQ(error_of_entities(R"([{"name": "a", "parent": "b"}, {"name": "b", "parent": "c"},
                                    {"name": "c", "parent": "b"}])"),
              "s.json: /entities/2/parent: 'c' hangs on itself through its parents");
    EXPECT_EQ(error_of_entities(R"([{"name": "a", "parent": "a"}])"),
              "s.json: /entities/0/parent: 'a' hangs on itself through its parents");
    EXPECT_EQ(error_of_entities(R"([{"camera": {}}])"), "s.json: /entities/0: needs a \"name\"");
    EXPECT_EQ(error_of_entities(R"([{"name": "a", "remove": true}])"),
              "s.json: /entities/0/remove: no included file has an entity 'a'");
    EXPECT_EQ(world.entity_count(), 0u);
}

TEST_F(SceneDocuments, ErrorsOfTheFileItself) {
    EXPECT_EQ(error_of_reading("none.json"), "none.json: there is no such file");
    put("s.json", "{}");
    EXPECT_EQ(error_of_reading("s.json"),
              "s.json: is no scene: it must begin with {\"secondlight_scene\": 1, …");
    put("s.json", R"({"secondlight_scene": 2})");
    EXPECT_EQ(error_of_reading("s.json"), "s.json: /secondlight_scene: is 2, but this program knows versions up to 1; open the file with a newer one");
    put("s.json", R"({"secondlight_scene": 1, "entitys": []})");
    EXPECT_EQ(
        error_of_reading("s.json"),
        "s.json: there is no key 'entitys'; did you mean 'entities'? Known: secondlight_scene, description, "
        "include, entities, $schema");
    fs::resize_file(folder / "s.json", most_scene_bytes + 1);
    EXPECT_EQ(error_of_reading("s.json"), "s.json: has 67108865 bytes, at most 67108864 are read");
}

TEST_F(SceneDocuments, CommentsArePassedOver) {
    put("s.json", "/* A scene\n * of one */ {\"secondlight_scene\": 1, // the \"version\"\n"
                  "\"entities\": [/*[{*/ {\"name\": \"a // b\"}]}\n// the end");
    EXPECT_EQ(error_of_reading("s.json"), "");
    EXPECT_TRUE(named("a // b"));
}

TEST_F(SceneDocuments, IncludesStayInTheFolder) {
    const auto error_of_include = [&](const std::string& include) {
        put("in/s.json", R"({"secondlight_scene": 1, "include": ")" + include + "\"}");
        return error_of_reading("in/s.json");
    };
    put("outside.json", R"({"secondlight_scene": 1})");
    EXPECT_EQ(error_of_include("../outside.json"),
              "in/s.json: /include: '../outside.json' leaves the folder of the file that includes it");
    EXPECT_NE(error_of_include("/etc/passwd").find("must be relative"), std::string::npos);
    EXPECT_EQ(error_of_include("none.json"), "in/s.json: /include: 'none.json': there is no such file");
    EXPECT_NE(error_of_include("").find("names no file"), std::string::npos);
    EXPECT_NE(error_of_include("."), "");
    EXPECT_NE(error_of_include("a\\u0000b"), "");
    fs::create_symlink("../outside.json", folder / "in" / "link.json");
    EXPECT_NE(error_of_include("link.json").find("leaves the folder"), std::string::npos);
}

TEST_F(SceneDocuments, IncludesEndSomewhere) {
    put("a.json", R"({"secondlight_scene": 1, "include": "b.json"})");
    put("b.json", R"({"secondlight_scene": 1, "include": "a.json"})");
    EXPECT_EQ(error_of_reading("a.json"),
              "b.json: /include: 'a.json' is already being read: files include each other in a circle");
    const auto chain = [&](int files) {
        for (int i = 0; i < files; ++i) {
            put(std::to_string(i) + ".json",
                R"({"secondlight_scene": 1, "include": ")" + std::to_string(i + 1) + ".json\"}");
        }
        put(std::to_string(files) + ".json", R"({"secondlight_scene": 1, "entities": [{"name": "last"}]})");
        return error_of_reading("0.json");
    };
    EXPECT_EQ(chain(8), "");
    EXPECT_TRUE(named("last"));
    EXPECT_EQ(chain(9), "8.json: /include: more than 8 files deep");
}

TEST_F(SceneDocuments, ALongChainOfParentsIsFine) {
    std::string entities = R"([{"name": "0"})";
    for (int i = 1; i < 20000; ++i) {
        const std::string self = std::to_string(i), above = std::to_string(i - 1);
        entities += R"(,{"name": ")" + self + R"(", "parent": ")" + above + "\"}";
    }
    EXPECT_EQ(error_of_entities(entities + "]"), "");
    EXPECT_EQ(world.entity_count(), 20000u);
}

}  // namespace
}  // namespace sl
