// SPDX-License-Identifier: MIT
#include "editor/scene_tab.h"

#include <gmock/gmock.h>

#include <fstream>

#include "editor/component_widgets.h"
#include "editor/entity_edits.h"
#include "editor/entity_tree.h"
#include "engine/ecs/parent.h"
#include "engine/ecs/scene_file.h"
#include "engine/ecs/systems/load_models.h"
#include "tests/editor/panel_test.h"

namespace sl {
namespace {

using testing::HasSubstr;
using testing::Not;

class SceneTabTest : public PanelTest {
  protected:
    std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();

    SceneTabTest() {
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    std::string file(const char* name) const { return (folder_ / name).string(); }
    std::function<void()> drawing() {
        return [this] { scene_tab(scene(), state_.scene); };
    }
    std::string shown() { return PanelTest::shown(drawing()); }
};

TEST_F(SceneTabTest, ShowsNamedEntitiesBelowTheirParentsAndNoOthers) {
    app_.world.create(Name{"bulb"}, Parent{lamp_}, PointLight{});
    app_.world.create(Parent{lamp_}, Shape{});
    const std::string text = shown();
    for (const char* word : {"box", "eye", "heaven", "lamp", "bulb", "sunlight"}) EXPECT_THAT(text, HasSubstr(word));
    EXPECT_LT(text.find("lamp"), text.find("bulb"));
    EXPECT_LT(text.find("bulb"), text.find("sunlight"));
    EXPECT_THAT(text, Not(HasSubstr("(no name)")));
}

TEST_F(SceneTabTest, FiltersByNameInAnyCase) {
    state_.scene.filter = "BO";
    const std::string text = shown();
    EXPECT_THAT(text, HasSubstr("box"));
    EXPECT_THAT(text, Not(HasSubstr("lamp")));
}

TEST_F(SceneTabTest, ShowsTheChosenEntityAlsoAfterItsDeletionIsUndone) {
    select(lamp_);
    EXPECT_THAT(shown(), HasSubstr("outer_cone"));
    delete_entity(scene(), lamp_);
    EXPECT_THAT(shown(), Not(HasSubstr("outer_cone")));
    state_.history.undo(app_.world, app_.registry());
    EXPECT_THAT(shown(), HasSubstr("outer_cone"));
}

TEST_F(SceneTabTest, WarnsOfNamesWithWhichASceneCannotBeSaved) {
    select(lamp_);
    EXPECT_THAT(shown(), Not(HasSubstr("cannot be saved")));
    app_.world.get<Name>(lamp_).value = "box";
    EXPECT_THAT(shown(), HasSubstr("Another entity has this name"));
    app_.world.get<Name>(lamp_).value = "";
    EXPECT_THAT(shown(), HasSubstr("nameless"));
}

TEST_F(SceneTabTest, AHeaderRemovesItsComponentAndUndoBringsItBack) {
    const ComponentType& type = *app_.registry().find("spot_light");
    app_.world.get<SpotLight>(lamp_).intensity = 7.0f;
    ImVec2 low{}, high{};
    const auto draw = [&] {
        if (!app_.world.has<SpotLight>(lamp_)) return;
        low = ImGui::GetCursorScreenPos();
        high = ImVec2(low.x + ImGui::GetContentRegionAvail().x, low.y + ImGui::GetFrameHeight());
        component_section(scene(), type, lamp_, false);
    };
    frame(draw);
    click(ImVec2(high.x - ImGui::GetFontSize() * 0.5f, 0.5f * (low.y + high.y)), draw);
    EXPECT_FALSE(app_.world.has<SpotLight>(lamp_));
    state_.history.undo(app_.world, app_.registry());
    EXPECT_EQ(app_.world.get<SpotLight>(lamp_).intensity, 7.0f);
}

TEST_F(SceneTabTest, ASavedSceneIsReadBackAndReloadingCanBeUndone) {
    const std::string path = file("saved.json");
    EXPECT_FALSE(save_scene(scene(), path).failed);
    app_.world.get<SpotLight>(lamp_).intensity = 7.0f;
    app_.world.add(camera_, Parent{lamp_});
    EXPECT_FALSE(reload_scene(scene()).failed);
    EXPECT_EQ(EntityTree(app_.world).all().size(), 5u);
    const auto lamp = [&] { return EntityTree(app_.world).all()[3]; };
    EXPECT_EQ(app_.world.get<SpotLight>(lamp()).intensity, SpotLight{}.intensity);
    state_.history.undo(app_.world, app_.registry());
    EXPECT_EQ(app_.world.get<SpotLight>(lamp()).intensity, 7.0f);
    const EntityTree tree(app_.world);
    EXPECT_EQ(tree.below(lamp()).size(), 1u);
    state_.history.redo(app_.world, app_.registry());
    EXPECT_EQ(app_.world.get<SpotLight>(lamp()).intensity, SpotLight{}.intensity);
}

TEST_F(SceneTabTest, WhatCannotBeSavedOrReadIsSaidAndChangesNothing) {
    EXPECT_THAT(save_scene(scene(), file("no/such/folder.json")).text, HasSubstr("no/such"));
    EXPECT_TRUE(reload_scene(scene()).failed);
    const std::string path = file("broken.json");
    ASSERT_FALSE(save_scene(scene(), path).failed);
    std::ofstream(path) << "{\"secondlight_scene\": 1, \"entities\": [{\"name\": \"x\", \"lamp\": {}}]}";
    const Outcome outcome = reload_scene(scene());
    EXPECT_TRUE(outcome.failed);
    EXPECT_THAT(outcome.text, HasSubstr("broken.json"));
    EXPECT_EQ(EntityTree(app_.world).all().size(), 5u);
    EXPECT_TRUE(state_.history.done().empty());
}

TEST_F(SceneTabTest, AModelIsFoundFromWhereverItsSceneIsSaved) {
    const auto before = (folder_ / "ship.glb").lexically_normal();
    app_.world.add_resource(SceneInfo{.description = "", .path = file("first.json")});
    const ModelFile ship{.file = "ship.glb"};
    app_.world.add(lamp_, ship);
    std::filesystem::create_directories(folder_ / "other");
    ASSERT_FALSE(save_scene(scene(), file("other/second.json")).failed);
    EXPECT_EQ(app_.world.get<ModelFile>(lamp_), ship);
    EXPECT_EQ(model_path(app_.world, ship).lexically_normal(), before);
    ASSERT_FALSE(save_scene(scene(), file("other/third.json")).failed);
    ASSERT_FALSE(reload_scene(scene()).failed);
    const Entity lamp = EntityTree(app_.world).all()[3];
    EXPECT_EQ(app_.world.get<ModelFile>(lamp).file, "../ship.glb");
    EXPECT_EQ(model_path(app_.world, app_.world.get<ModelFile>(lamp)).lexically_normal(), before);
}

TEST_F(SceneTabTest, AFileThatIsThereIsOnlyReplacedOnceSomebodySaidSo) {
    const std::string path = file("mine.json");
    std::ofstream(path) << "{\"include\": \"a.json\"} // precious";
    const auto bytes = std::filesystem::file_size(path);
    state_.scene.file.path = path;
    frame(drawing());
    frame(drawing());
    // Save is the first button.
    const float half_line = 0.5f * ImGui::GetFrameHeight();
    click(ImVec2(ImGui::GetStyle().WindowPadding.x + half_line, ImGui::GetStyle().WindowPadding.y + half_line), drawing());
    EXPECT_EQ(std::filesystem::file_size(path), bytes);
    EXPECT_EQ(state_.scene.file.lost, " Its comments would be lost. What it includes would stand in it instead.");
    frame(drawing());
    EXPECT_TRUE(ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel));
}

}  // namespace
}  // namespace sl
