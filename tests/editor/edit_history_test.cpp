// SPDX-License-Identifier: MIT
#include "editor/edit_history.h"

#include <gtest/gtest.h>

#include "engine/core/field_setter.h"
#include "tests/editor/edited_scene.h"

namespace sl {
namespace {

class EditHistoryTest : public testing::Test {
  protected:
    SmallScene scene_;

    SpotLight& lamp() { return scene_.app.world.get<SpotLight>(scene_.find("lamp")); }
    void drag_intensity_to(std::string_view text) {
        FieldSetter setter("spot_light", "intensity", text);
        scene_.change(scene_.find("lamp"), "spot_light", setter);
    }
};

TEST_F(EditHistoryTest, ADeletedBranchComesBackWithItsParents) {
    const std::string before = scene_.text();
    delete_entity(scene_.edited(), scene_.find("house"));
    EXPECT_FALSE(scene_.find("lamp"));
    scene_.undo();
    EXPECT_EQ(scene_.text(), before);
    EXPECT_EQ(scene_.app.world.get<Parent>(scene_.find("lamp")).entity, scene_.find("house"));
    scene_.redo();
    EXPECT_FALSE(scene_.find("house"));
}

TEST_F(EditHistoryTest, StepsFindAnEntityThatCameBack) {
    const Entity lamp = scene_.find("lamp");
    remove_component(scene_.edited(), lamp, scene_.type("spot_light"));
    delete_entity(scene_.edited(), lamp);
    scene_.undo();
    ASSERT_FALSE(scene_.app.world.alive(lamp));
    scene_.undo();
    EXPECT_TRUE(scene_.app.world.has<SpotLight>(scene_.find("lamp")));
}

TEST_F(EditHistoryTest, AGestureIsOneStep) {
    for (const char* value : {"1", "20", "300"}) drag_intensity_to(value);
    scene_.history.end_gesture();
    drag_intensity_to("4000");
    EXPECT_EQ(scene_.history.done().size(), 2u);
    scene_.undo();
    EXPECT_EQ(lamp().intensity, 300.0f);
    scene_.undo();
    EXPECT_EQ(lamp().intensity, SpotLight{}.intensity);
    scene_.redo();
    EXPECT_EQ(lamp().intensity, 300.0f);
}

TEST_F(EditHistoryTest, KnowsWhetherAFileHoldsTheScene) {
    EXPECT_TRUE(scene_.history.saved()) << "nothing was done";
    drag_intensity_to("20");
    EXPECT_FALSE(scene_.history.saved());
    scene_.history.mark_saved();
    drag_intensity_to("300");
    EXPECT_FALSE(scene_.history.saved()) << "what goes on after saving is a step of its own";
    scene_.undo();
    EXPECT_TRUE(scene_.history.saved());
    scene_.undo();
    EXPECT_FALSE(scene_.history.saved());
    drag_intensity_to("1");
    scene_.undo();
    scene_.redo();
    EXPECT_FALSE(scene_.history.saved()) << "what was saved cannot be reached any more";
}

TEST_F(EditHistoryTest, AGestureThatEndsWhereItBeganIsNone) {
    drag_intensity_to("1");
    drag_intensity_to(fmt::format("{}", SpotLight{}.intensity));
    scene_.history.end_gesture();
    EXPECT_TRUE(scene_.history.done().empty());
}

TEST_F(EditHistoryTest, ANewStepForgetsWhatWasUndone) {
    drag_intensity_to("1");
    scene_.undo();
    add_entity(scene_.edited(), {});
    EXPECT_TRUE(scene_.history.undone().empty());
    EXPECT_EQ(scene_.history.done().size(), 1u);
}

TEST_F(EditHistoryTest, WhatTheGameDidInBetweenStays) {
    drag_intensity_to("1");
    scene_.app.world.get<Transform>(scene_.find("lamp")).translation = dvec3(1, 2, 3);
    scene_.app.world.destroy(scene_.find("eye"));
    scene_.undo();
    EXPECT_EQ(scene_.app.world.get<Transform>(scene_.find("lamp")).translation, dvec3(1, 2, 3));
    EXPECT_FALSE(scene_.find("eye"));
}

TEST_F(EditHistoryTest, StepsOfAnEntityThatTheGameDestroyedDoNothing) {
    drag_intensity_to("1");
    scene_.app.world.destroy(scene_.find("lamp"));
    scene_.undo();
    scene_.redo();
    EXPECT_FALSE(scene_.find("lamp"));
}

TEST_F(EditHistoryTest, ExtremeValuesComeBackFiniteAndInsideTheirRanges) {
    const Entity lamp_entity = scene_.find("lamp");
    const float infinite = std::numeric_limits<float>::infinity();
    for (const float value : {std::numeric_limits<float>::quiet_NaN(), infinite, -infinite, 3e38f, 1e-45f}) {
        lamp().intensity = lamp().outer_cone = value;
        scene_.app.world.get<Transform>(lamp_entity).translation = dvec3(double{value});
        scene_.app.world.get<Transform>(lamp_entity).rotation = quat(value, value, value, value);
        FieldClamp none;
        for (const char* component : {"spot_light", "transform"}) {
            scene_.change(lamp_entity, component, none);
            scene_.history.end_gesture();
        }
        scene_.undo();
        scene_.undo();
        scene_.redo();
        scene_.redo();
        EXPECT_TRUE(lamp().intensity >= 0.0f && lamp().intensity <= 1e9f);
        EXPECT_TRUE(lamp().outer_cone > 0.0f && lamp().outer_cone < 2.0f);
        EXPECT_LE(glm::length(scene_.app.world.get<Transform>(lamp_entity).translation), 2e7);
        EXPECT_NEAR(glm::length(scene_.app.world.get<Transform>(lamp_entity).rotation), 1.0f, 1e-5f);
    }
}

TEST_F(EditHistoryTest, ACopyHasAllBelowItUnderFreeNames) {
    const Entity copy = duplicate_entity(scene_.edited(), scene_.find("house"));
    EXPECT_EQ(copy, scene_.find("house 2"));
    EXPECT_EQ(scene_.app.world.get<Parent>(scene_.find("lamp 2")).entity, copy);
    EXPECT_EQ(free_name(scene_.app.world, "house 2"), "house 3");
    scene_.undo();
    EXPECT_EQ(scene_.entities().size(), 3u);
    scene_.redo();
    EXPECT_EQ(scene_.app.world.get<Parent>(scene_.find("lamp 2")).entity, scene_.find("house 2"));
}

}  // namespace
}  // namespace sl
