// SPDX-License-Identifier: MIT
#include "game/fly_camera.h"

#include <gtest/gtest.h>

namespace sl {
namespace {

class FlyCameraTest : public testing::Test {
  protected:
    App app_;
    Entity camera_ = app_.world.create(Camera{}, Transform{});

    FlyCameraTest() {
        app_.world.add_resource(FrameClock{});
        add_fly_camera(app_);
    }
    Input& input() { return app_.world.resource<Input>(); }
    Transform& place() { return app_.world.get<Transform>(camera_); }
    void hold(Key key) { input().keys_down.set(static_cast<std::size_t>(key)); }
    void run(int frames, double step) {
        app_.world.resource<FrameClock>().step = step;
        for (int i = 0; i < frames; ++i) app_.schedule.run(app_.world);
    }
};

void expect_near(const dvec3& a, const dvec3& b, double tolerance = 1e-6) {
    EXPECT_LT(glm::length(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST_F(FlyCameraTest, FliesAsFarAtAnyFrameRate) {
    hold(Key::w);
    run(100, 0.01);
    const dvec3 quick = place().translation;
    expect_near(quick, {0, 0, -app_.world.resource<FlyCamera>().speed}, 1e-4);
    place().translation = dvec3(0.0);
    run(10, 0.1);
    expect_near(place().translation, quick, 1e-4);
}

TEST_F(FlyCameraTest, KeysGoTheirWays) {
    const double speed = app_.world.resource<FlyCamera>().speed;
    const std::pair<Key, dvec3> ways[] = {{Key::w, {0, 0, -1}}, {Key::s, {0, 0, 1}}, {Key::a, {-1, 0, 0}},
                                          {Key::d, {1, 0, 0}},  {Key::e, {0, 1, 0}}, {Key::q, {0, -1, 0}}};
    for (const auto& [key, way] : ways) {
        place() = {};
        input() = {};
        hold(key);
        run(1, 1.0);
        expect_near(place().translation, way * speed, 1e-4);
    }
}

TEST_F(FlyCameraTest, TwoKeysAreNoFasterThanOneAndShiftIs) {
    const FlyCamera fly = app_.world.resource<FlyCamera>();
    hold(Key::w);
    hold(Key::d);
    run(1, 1.0);
    EXPECT_NEAR(glm::length(place().translation), fly.speed, 1e-4);
    place().translation = dvec3(0.0);
    hold(Key::shift);
    run(1, 1.0);
    EXPECT_NEAR(glm::length(place().translation), fly.speed * fly.fast, 1e-3);
}

TEST_F(FlyCameraTest, StaysLevelWhereverItLooks) {
    for (const float pitch : {-1.5707f, -1.0f, 0.5f, 1.5707f}) {
        place() = {.rotation = glm::angleAxis(0.8f, vec3(0, 1, 0)) * glm::angleAxis(pitch, vec3(1, 0, 0))};
        input() = {};
        hold(Key::w);
        run(1, 1.0);
        const double speed = app_.world.resource<FlyCamera>().speed;
        expect_near(place().translation, dvec3(-std::sin(0.8), 0, -std::cos(0.8)) * speed, 1e-2);
    }
}

TEST_F(FlyCameraTest, KeepsMillimetresFarFromTheOrigin) {
    place().translation = dvec3(5e6, 0, -5e6);
    app_.world.resource<FlyCamera>().speed = 0.1;
    hold(Key::w);
    run(100, 0.01);
    expect_near(place().translation, dvec3(5e6, 0, -5e6 - 0.1), 1e-5);
}

TEST_F(FlyCameraTest, MouseTurnsAndStopsShortOfStraightUp) {
    input().mouse_delta = vec2(100, 0);
    run(1, 0.01);
    const vec3 forward = place().rotation * vec3(0, 0, -1);
    EXPECT_GT(forward.x, 0.1f);
    EXPECT_NEAR(forward.y, 0.0f, 1e-6f);
    input().mouse_delta = vec2(0, -1e6f);
    run(3, 0.01);
    const vec3 up = place().rotation * vec3(0, 0, -1);
    EXPECT_GT(up.y, 0.999f);
    EXPECT_LT(up.y, 1.0f);
    EXPECT_GT((place().rotation * vec3(0, 1, 0)).y, 0.0f);
}

TEST_F(FlyCameraTest, TurningBackComesBack) {
    quat rotation = glm::angleAxis(0.4f, vec3(0, 1, 0)) * glm::angleAxis(-0.3f, vec3(1, 0, 0));
    const quat before = rotation;
    for (int i = 0; i < 1000; ++i) rotation = look_turned(rotation, vec2(0.01f, i % 2 == 0 ? 0.02f : -0.02f));
    for (int i = 0; i < 1000; ++i)
        rotation = look_turned(rotation, vec2(-0.01f, i % 2 == 0 ? 0.02f : -0.02f));
    EXPECT_GT(std::abs(glm::dot(rotation, before)), 0.9999f);
}

TEST_F(FlyCameraTest, TheWheelSetsTheSpeed) {
    const double before = app_.world.resource<FlyCamera>().speed;
    hold(Key::control);
    input().scroll = 2.0f;
    run(1, 0.01);
    EXPECT_GT(app_.world.resource<FlyCamera>().speed, before * 1.2);
    EXPECT_GT(app_.world.resource<Notice>().seconds_left, 0.0);
    input().scroll = -1000.0f;
    run(1, 0.01);
    EXPECT_GT(app_.world.resource<FlyCamera>().speed, 0.0);
}

TEST_F(FlyCameraTest, LeavesInactiveCamerasAndRollUntilAsked) {
    app_.world.get<Camera>(camera_).active = false;
    const Entity second =
        app_.world.create(Camera{}, Transform{.rotation = glm::angleAxis(0.5f, vec3(0, 0, 1))});
    hold(Key::w);
    run(1, 1.0);
    EXPECT_EQ(place().translation, dvec3(0.0));
    EXPECT_NE(app_.world.get<Transform>(second).translation, dvec3(0.0));
    EXPECT_EQ(app_.world.get<Transform>(second).rotation, glm::angleAxis(0.5f, vec3(0, 0, 1)));
}

}  // namespace
}  // namespace sl
