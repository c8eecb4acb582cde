// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "editor/component_widgets.h"
#include "editor/editor_panel.h"
#include "engine/ecs/components.h"
#include "tests/editor/imgui_test.h"

namespace sl {
namespace {

using testing::HasSubstr;
using testing::Not;

class SceneSectionsTest : public ImguiTest {
  protected:
    App app_;
    EditorState state_{.open = true};
    Entity camera_ = app_.world.create(Name{"eye"}, Camera{}, Transform{}, GiSettings{RsmGrid{}});
    Entity lamp_ = app_.world.create(Name{"lamp"}, SpotLight{}, Transform{});

    SceneSectionsTest() {
        app_.world.create(Name{"sunlight"}, SunAngles{}, DirectionalLight{});
        app_.world.create(Name{"heaven"}, SkyLight{});
        app_.world.create(Name{"box"}, Shape{}, Material{}, Transform{});
    }

    std::function<void()> drawing() {
        return [this] {
            for (const char* header :
                 {"Global illumination", "Lights", "Camera and exposure", "All entities"}) {
                ImGui::GetStateStorage()->SetInt(ImGui::GetID(header), 1);
            }
            scene_sections(app_, state_);
        };
    }
    std::string shown() {
        frame(drawing());
        return text_of(drawing());
    }
};

TEST_F(SceneSectionsTest, ShowsMethodPresetAndEverySetting) {
    const std::string text = shown();
    for (const char* word :
         {"rsm_grid", "preset", "paper", "angle_threshold", "distance_attenuation", "cutoff"}) {
        EXPECT_THAT(text, HasSubstr(word));
    }
    EXPECT_THAT(text, Not(HasSubstr("low_resolution")));
}

TEST_F(SceneSectionsTest, ShowsEachLightByNameAndEveryEntity) {
    const std::string text = shown();
    for (const char* word : {"lamp", "spot_light", "outer_cone", "sunlight", "azimuth", "illuminance",
                             "heaven", "luminance", "ev100", "box", "eye"}) {
        EXPECT_THAT(text, HasSubstr(word));
    }
}

TEST_F(SceneSectionsTest, FiltersEntitiesByName) {
    state_.filter = "bo";
    const std::string text = shown();
    const std::string list = text.substr(text.find("All entities"));
    EXPECT_THAT(list, HasSubstr("box"));
    EXPECT_THAT(list, Not(HasSubstr("lamp")));
}

TEST_F(SceneSectionsTest, WithoutGiSettingsItOffersThem) {
    app_.world.remove<GiSettings>(camera_);
    EXPECT_THAT(shown(), HasSubstr("Add GI settings"));
}

TEST_F(SceneSectionsTest, WithoutACameraItSaysSo) {
    app_.world.get<Camera>(camera_).active = false;
    EXPECT_THAT(shown(), HasSubstr("No camera is active"));
}

TEST_F(SceneSectionsTest, ComponentsMayComeAndGoWhileItIsOpen) {
    for (int i = 0; i < 4; ++i) {
        frame(drawing());
        app_.world.destroy(lamp_);
        lamp_ = app_.world.create(Name{"lamp"}, PointLight{}, Transform{});
        app_.schedule.run(app_.world);
    }
    EXPECT_THAT(shown(), HasSubstr("point_light"));
}

TEST_F(SceneSectionsTest, AHeaderRemovesItsComponent) {
    const ComponentType& type = *app_.registry().find("spot_light");
    ImVec2 low{}, high{};
    const auto draw = [&] {
        if (!app_.world.has<SpotLight>(lamp_)) return;
        low = ImGui::GetCursorScreenPos();
        high = ImVec2(low.x + ImGui::GetContentRegionAvail().x, low.y + ImGui::GetFrameHeight());
        component_section(app_.world, type, lamp_, false);
    };
    frame(draw);
    click(ImVec2(high.x - ImGui::GetFontSize() * 0.5f, 0.5f * (low.y + high.y)), draw);
    EXPECT_FALSE(app_.world.has<SpotLight>(lamp_));
}

}  // namespace
}  // namespace sl
