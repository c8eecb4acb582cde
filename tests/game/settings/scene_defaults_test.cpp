// SPDX-License-Identifier: MIT
#include "game/settings/scene_defaults.h"

#include <gtest/gtest.h>

#include "engine/core/clock.h"
#include "engine/ecs/components.h"
#include "game/gi_presets.h"

namespace sl {
namespace {

class SceneDefaultsTest : public testing::Test {
  protected:
    App app_;
    Entity camera_ = app_.world.create(Camera{.fov_y = 0.7f}, GiSettings{RsmGrid{.strength = 0.7f}});
    Entity bare_ = app_.world.create(Camera{.active = false});

    SceneDefaultsTest() { keep_scene_defaults(app_); }
    const GiMethod& method() { return app_.world.get<GiSettings>(camera_).method; }
};

LightSettings light_of(std::string_view method) {
    const auto names = gi_method_names();
    return {.method = static_cast<std::size_t>(1 + (std::ranges::find(names, method) - names.begin()))};
}

TEST_F(SceneDefaultsTest, UsualSettingsLeaveASceneAsItIs) {
    apply_light(app_, {});
    apply_field_of_view(app_, {});
    EXPECT_EQ(method().get<RsmGrid>().strength, 0.7f);
    EXPECT_EQ(app_.world.get<Camera>(camera_).fov_y, 0.7f);
    EXPECT_FALSE(app_.world.has<GiSettings>(bare_));
}

TEST_F(SceneDefaultsTest, EachMethodCanBeChosenAndTakenBack) {
    for (const std::string_view name : gi_method_names()) {
        for (std::size_t preset = 0; preset < 4; ++preset) {
            LightSettings light = light_of(name);
            light.preset = preset;
            apply_light(app_, light);
            EXPECT_EQ(method().name(), name);
        }
    }
    apply_light(app_, {});
    EXPECT_EQ(method().get<RsmGrid>().strength, 0.7f);
    EXPECT_FALSE(app_.world.has<GiSettings>(bare_));
}

TEST_F(SceneDefaultsTest, FacetsTakeQualityAndBudget) {
    LightSettings light = light_of("facets");
    light.quality = 1.0f;
    light.budget_ms = 3.5f;
    apply_light(app_, light);
    EXPECT_EQ(method().get<Facets>().budget_ms, 3.5f);
    EXPECT_LT(method().get<Facets>().spacing, Facets{}.spacing);
}

TEST_F(SceneDefaultsTest, TheFieldOfViewIsThePlayersOrTheScenes) {
    apply_field_of_view(app_, {.scene_field_of_view = false, .field_of_view = 1.5f});
    EXPECT_EQ(app_.world.get<Camera>(camera_).fov_y, 1.5f);
    apply_field_of_view(app_, {.scene_field_of_view = true, .field_of_view = 1.5f});
    EXPECT_EQ(app_.world.get<Camera>(camera_).fov_y, 0.7f);
}

TEST_F(SceneDefaultsTest, CamerasThatAreGoneAreLeftAlone) {
    app_.world.destroy(camera_);
    app_.world.remove<Camera>(bare_);
    apply_field_of_view(app_, {.scene_field_of_view = false});
    apply_light(app_, light_of("facets"));
    apply_light(app_, {});
}

}  // namespace
}  // namespace sl
