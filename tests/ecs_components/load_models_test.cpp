// SPDX-License-Identifier: MIT
#include "engine/ecs/systems/load_models.h"

#include <thread>

#include "engine/core/image.h"
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
    void write_picture(const char* name) {
        Image image(2, 2, 3);
        write_png(folder / name, image);
    }
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

/// All that models take in the world.
struct Held {
    std::size_t meshes, materials, colours, entities;
    bool operator==(const Held&) const = default;
};

TEST_F(LoadModelsTest, AModelThatIsGoneGivesBackWhatItHeld) {
    write_picture("p.png");
    json["images"] = {{{"uri", "p.png"}}};
    json["textures"] = {{{"source", 0}}};
    json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 0;
    // One mesh is moved by a morph, so each entity that shows it has its own.
    json["meshes"].push_back(json["meshes"][0]);
    json["meshes"][1]["primitives"][0]["targets"] = {{{"POSITION", json["meshes"][0]["primitives"][0]["attributes"]["POSITION"]}}};
    json["nodes"][2]["mesh"] = 1;
    const auto first = write("first.gltf"), second = write("second.gltf"), kept = write("kept.gltf");
    const auto held = [&] {
        const auto& colours = app.world.resource<PictureTable>().colours;
        return Held{app.world.resource<MeshPool>().size(), app.world.resource<MaterialTable>().entries.size(), colours ? colours->layers.size() : 0, app.world.entity_count()};
    };
    const Entity entity = add(first);
    add(kept);
    app.schedule.run(app.world);
    const Held two = held();
    EXPECT_EQ(two.colours, 2u);
    EXPECT_EQ(two.meshes, 4u);
    for (int i = 0; i < 50; ++i) {
        app.world.get<ModelFile>(entity).file = (i % 2 == 0 ? second : first).string();
        app.schedule.run(app.world);
        ASSERT_EQ(held(), two) << "after " << i + 1 << " changes";
        app.world.remove<ModelFile>(entity);
        app.schedule.run(app.world);
        ASSERT_EQ(held().colours, 1u);
        ASSERT_EQ(held().meshes, 2u);
        // What is left still finds its material and its picture.
        for (auto [shown, instance] : Query<const MeshInstance>(app.world)) {
            const auto& row = app.world.resource<MaterialTable>().entries.at(static_cast<std::size_t>(instance.first_material));
            EXPECT_EQ(row.material.base_colour, vec3(0.2f, 0.4f, 0.6f));
            ASSERT_TRUE(row.pictures);
            EXPECT_EQ(row.pictures->layers.x, 0u);
        }
        app.world.add(entity, ModelFile{.file = first.string()});
        app.schedule.run(app.world);
    }
    EXPECT_EQ(held(), two);
}

TEST_F(LoadModelsTest, AFileThatIsWantedAgainWhileItIsReadComesWhole) {
    app.world.resource<ModelLibrary>().at_once = false;
    const auto file = write();
    const Entity entity = add(file);
    for (int i = 0; i < 20; ++i) {
        app.world.get<ModelFile>(entity).file = i % 2 == 0 ? "" : file.string();
        app.schedule.run(app.world);
    }
    for (int frame = 0; frame < 500 && meshes() == 0; ++frame) {
        app.schedule.run(app.world);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    EXPECT_EQ(meshes(), 2u);
}

TEST_F(LoadModelsTest, MoreThanAWorldCanTakeIsNotShown) {
    // 64 nodes of 65536 triangles each; so many of these models fit, and no more.
    constexpr std::size_t corners = 3 * 65'536, nodes = 64, fits = most_model_cost.triangles / (corners / 3 * nodes);
    json["meshes"][0]["primitives"][0]["indices"] = add_accessor(std::vector<std::uint16_t>(corners, 1), 5123, "SCALAR", corners);
    json["nodes"] = std::vector<Json>(nodes, {{"mesh", 0}});
    for (std::size_t i = 1; i < nodes; ++i) json["scenes"][0]["nodes"].push_back(i);
    const auto file = write();
    for (std::size_t i = 0; i < fits; ++i) add(file);
    app.schedule.run(app.world);
    EXPECT_EQ(meshes(), fits * nodes);
    const Entity more = add(file);
    EXPECT_THROW(app.schedule.run(app.world), Error);
    app.world.resource<ModelLibrary>().at_once = false;
    app.schedule.run(app.world);
    EXPECT_EQ(meshes(), fits * nodes);
    ASSERT_EQ(app.world.resource<ModelLibrary>().faults().size(), 1u);
    EXPECT_NE(app.world.resource<ModelLibrary>().faults()[0].find("it is not shown, because all models together would have 272 million triangles; 268 million is the limit"), std::string::npos)
        << app.world.resource<ModelLibrary>().faults()[0];
    app.world.destroy(more);
    app.schedule.run(app.world);
    EXPECT_TRUE(app.world.resource<ModelLibrary>().faults().empty());
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
