// SPDX-License-Identifier: MIT
#include "engine/ecs/set_field.h"

#include "tests/ecs_components/scene_folder.h"

namespace sl {
namespace {

class SetField : public SceneFolder {
  protected:
    void set(std::string_view text) { set_field(world, registry, text); }
    std::string error(std::string_view text) {
        try {
            set(text);
        } catch (const std::exception& thrown) {
            return thrown.what();
        }
        return "";
    }
    const GiSettings& gi() const { return world.get<GiSettings>(view); }

    Entity view = world.create(Name{"view.main"}, Camera{}, GiSettings{RsmDisc{}});
    Entity other = world.create(Name{"other"}, Camera{});
};

TEST_F(SetField, SetsAllThatHaveTheComponent) {
    set("camera.fov_y=30deg");
    EXPECT_FLOAT_EQ(world.get<Camera>(view).fov_y, pi / 6.0f);
    EXPECT_FLOAT_EQ(world.get<Camera>(other).fov_y, pi / 6.0f);
}

TEST_F(SetField, SetsOneByNameEvenWithDotsInIt) {
    set("view.main.camera.ev100=3");
    EXPECT_EQ(world.get<Camera>(view).ev100, 3.0f);
    EXPECT_EQ(world.get<Camera>(other).ev100, Camera().ev100);
}

TEST_F(SetField, MethodThenItsFields) {
    set("gi.method=rsm_grid");
    set("gi.strength=0.6");
    set("gi.angle_threshold=0.05");
    EXPECT_EQ(gi().method.get<RsmGrid>().strength, 0.6f);
    set("gi.preset=paper");
    EXPECT_EQ(gi().method.get<RsmGrid>().strength, 0.3f);
    EXPECT_EQ(gi().method.get<RsmGrid>().angle_threshold, 0.01f);
    set("gi.method=off");
    EXPECT_EQ(gi().method.name(), "off");
}

TEST_F(SetField, ErrorsSayWhatToWrite) {
    EXPECT_EQ(error("gi"), "'gi' sets nothing; write component.field=value or entity.component.field=value");
    EXPECT_EQ(error("strength=1"),
              "'strength=1' sets nothing; write component.field=value or entity.component.field=value");
    EXPECT_EQ(error("gi.radius=2"), "gi.radius: is 2, must be 0 to 1.5 map side");
    EXPECT_EQ(error("view.main.gi.radius=2"), "view.main.gi.radius: is 2, must be 0 to 1.5 map side");
    EXPECT_EQ(error("gi.step=2"),
              "gi: there is no field 'step'. Known: method, rsm_size, samples, radius, rotate, interpolate, "
              "low_resolution, position_tolerance, normal_tolerance, strength");
    EXPECT_EQ(error("sky.luminance=2"), "sky.luminance=2: no entity has the component 'sky'");
    EXPECT_EQ(error("other.gi.strength=2"), "other.gi.strength=2: no entity 'other' has the component 'gi'");
    EXPECT_EQ(error("othr.gi.strength=2"),
              "othr.gi.strength=2: there is no entity 'othr'; did you mean 'other'? Known: view.main, other");
    EXPECT_NE(error("cam.fov_y=1").find("there is no component 'cam'"), std::string::npos);
    for (const char* odd :
         {"", "=", ".", ".=", "..=", "a.=", ".a=", "camera.=1", "..camera.near=1", "===", "\n.\n=\n"}) {
        EXPECT_NE(error(odd), "") << odd;
    }
}

}  // namespace
}  // namespace sl
