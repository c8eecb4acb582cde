// SPDX-License-Identifier: MIT
#include "engine/ecs/systems/load_models.h"

#include <thread>

#include "engine/ecs/app.h"
#include "engine/ecs/components.h"
#include "engine/ecs/parent.h"
#include "engine/ecs/query.h"
#include "tests/model/model_fixture.h"

namespace sl {
namespace {

/// A model of a square with a lamp above it, twice: in a child of a node that is moved.
class LoadModelsTest : public ModelTest {
  protected:
    void SetUp() override {
        ModelTest::SetUp();
        json["extensionsUsed"] = {"KHR_lights_punctual"};
        json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}, {"intensity", 40.0}}};
        json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorFactor", {0.2, 0.4, 0.6, 1}}}}}};
        json["meshes"] = {{{"primitives", {square({{"material", 0}})}}}};
        json["nodes"] = {{{"translation", {1, 2, 3}}, {"children", {1, 2}}}, {{"mesh", 0}}, {{"mesh", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}}};
        json["scenes"][0]["nodes"] = {0};
        app.world.resource<ModelLibrary>().at_once = true;
    }
    Entity add(const std::filesystem::path& file) { return app.world.create(Transform{.translation = dvec3(10, 0, 0)}, ModelFile{.file = file.string()}); }
    std::size_t meshes() {
        std::size_t count = 0;
        Query<const MeshInstance>(app.world).each([&](const MeshInstance&) { ++count; });
        return count;
    }

    App app;
};

TEST_F(LoadModelsTest, NodesMeshesMaterialsAndLightsAreEntities) {
    add(write());
    app.schedule.run(app.world);
    EXPECT_EQ(meshes(), 2u);
    for (auto [entity, instance, transform] : Query<const MeshInstance, const WorldTransform>(app.world)) {
        EXPECT_EQ(transform.origin, dvec3(11, 2, 3));
        EXPECT_EQ(app.world.resource<MaterialTable>().entries[static_cast<std::size_t>(instance.first_material)].material.base_colour, vec3(0.2f, 0.4f, 0.6f));
    }
    for (auto [entity, light] : Query<const PointLight>(app.world)) EXPECT_EQ(light.intensity, 40.0f);
}

TEST_F(LoadModelsTest, TwoThatShowOneFileShareItsMeshes) {
    const auto file = write();
    add(file);
    app.schedule.run(app.world);
    const std::size_t pool = app.world.resource<MeshPool>().size();
    add(file);
    app.schedule.run(app.world);
    EXPECT_EQ(meshes(), 4u);
    EXPECT_EQ(app.world.resource<MeshPool>().size(), pool);
}

TEST_F(LoadModelsTest, WithoutItsModelAnEntityShowsNothing) {
    const Entity first = add(write()), second = add(folder / "model.gltf");
    app.schedule.run(app.world);
    app.world.remove<ModelFile>(first);
    app.schedule.run(app.world);
    EXPECT_EQ(meshes(), 2u);
    app.world.destroy(second);
    app.schedule.run(app.world);
    EXPECT_EQ(meshes(), 0u);
}

TEST_F(LoadModelsTest, AFileThatCannotBeShownStopsAPictureAndNotAWindow) {
    const Entity entity = add(folder / "nowhere.glb");
    EXPECT_THROW(app.schedule.run(app.world), Error);
    app.world.resource<ModelLibrary>().at_once = false;
    const auto run_until = [&](auto&& done) {
        for (int frame = 0; frame < 500 && !done(); ++frame) {
            app.schedule.run(app.world);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    };
    auto& library = app.world.resource<ModelLibrary>();
    run_until([&] { return !library.faults().empty(); });
    ASSERT_EQ(library.faults().size(), 1u);
    EXPECT_NE(library.faults().front().find("nowhere.glb"), std::string::npos) << library.faults().front();
    EXPECT_EQ(meshes(), 0u);
    std::filesystem::rename(write(), folder / "nowhere.glb");
    run_until([&] { return meshes() > 0; });
    EXPECT_EQ(meshes(), 2u) << "once there is one, it comes";
    EXPECT_TRUE(library.faults().empty() && library.being_read().empty());
    app.world.get<ModelFile>(entity).file = "elsewhere.glb";
    run_until([&] { return !library.faults().empty(); });
    EXPECT_EQ(meshes(), 0u) << "what it was is gone";
}

}  // namespace
}  // namespace sl
