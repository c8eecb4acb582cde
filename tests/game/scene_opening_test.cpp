// SPDX-License-Identifier: MIT
#include <thread>

#include "engine/core/error.h"
#include "engine/ecs/query.h"
#include "game/session.h"
#include "tests/model/model_fixture.h"

namespace sl {
namespace {

/// A scene file beside a model that it shows.
class SceneOpeningTest : public ModelTest {
  protected:
    void SetUp() override {
        ModelTest::SetUp();
        show(square());
        write("square.gltf");
    }
    SceneChoice scene_of(const std::string& model) const {
        const Json entities{{{"name", "camera"}, {"transform", Json::object()}, {"camera", Json::object()}},
                            {{"name", "thing"}, {"transform", Json::object()}, {"model", {{"file", model}}}}};
        std::ofstream(folder / "scene.json") << Json{{"secondlight_scene", 1}, {"entities", entities}}.dump();
        return {.scene = (folder / "scene.json").string(), .gi = "off", .sets = {"camera.ev100=3"}};
    }
    /// As a window does it.
    static void advance_until_there(SceneOpening& opening) {
        for (int frame = 0; frame < 2000; ++frame) {
            if (opening.advance(false)) return;
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        FAIL() << "it never comes";
    }
    static std::size_t meshes(SceneOpening& opening) {
        std::size_t count = 0;
        Query<const MeshInstance>(opening.app.world).each([&](const MeshInstance&) { ++count; });
        return count;
    }
};

TEST_F(SceneOpeningTest, ASceneFileIsThereBeforeItsModels) {
    SceneOpening opening(scene_of("square.gltf"));
    EXPECT_TRUE(opening.shows_models());
    const Entity camera = active_camera(opening.app.world);
    ASSERT_TRUE(camera);
    EXPECT_EQ(opening.app.world.get<Camera>(camera).ev100, 3.0f) << "what is chosen holds before anything is made";
    EXPECT_EQ(meshes(opening), 0u);
    advance_until_there(opening);
    EXPECT_EQ(meshes(opening), 1u);
    EXPECT_TRUE(opening.being_read().empty());
}

TEST_F(SceneOpeningTest, AModelThatCannotBeShownIsAnErrorOfItsScene) {
    SceneOpening opening(scene_of("nowhere.gltf"));
    EXPECT_THROW(advance_until_there(opening), Error);
}

TEST_F(SceneOpeningTest, OtherScenesWaitForNothing) {
    SceneOpening opening({.scene = "cornell"});
    EXPECT_FALSE(opening.shows_models());
    EXPECT_TRUE(opening.advance(false));
}

}  // namespace
}  // namespace sl
