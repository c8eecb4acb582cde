// SPDX-License-Identifier: MIT
#include "engine/ecs/systems/day_cycle.h"

#include <gtest/gtest.h>

#include "engine/ecs/systems/engine_systems.h"
#include "engine/ecs/systems/sun_direction.h"

namespace sl {
namespace {

class DayCycleTest : public testing::Test {
  protected:
    World world;
    Schedule schedule;
    Entity sun, sky;

    DayCycleTest() {
        add_engine_resources(world);
        add_engine_systems(schedule);
        sky = world.create(SkyLight{});
        sun = world.create(Transform{}, SunAngles{}, DirectionalLight{}, DayCycle{.runs = false});
    }
    void run(double step = 0.0) {
        world.resource<FrameClock>().step = step;
        schedule.run(world);
    }
    DayCycle& day() { return world.get<DayCycle>(sun); }
    SunAngles& angles() { return world.get<SunAngles>(sun); }
    float sun_lux() { return world.get<DirectionalLight>(sun).illuminance * luminance(world.get<DirectionalLight>(sun).colour); }
    float sky_nit() { return world.get<SkyLight>(sky).luminance * luminance(world.get<SkyLight>(sky).colour); }
    vec3 to_light() { return -(world.get<Transform>(sun).rotation * vec3(0, 0, -1)); }
};

TEST_F(DayCycleTest, ADayTakesItsMinutes) {
    day() = {.runs = true, .hour = 6.0, .minutes = 10.0f};
    for (int i = 0; i < 600; ++i) run(0.5);
    EXPECT_NEAR(day().hour, 18.0, 1e-9);
    for (int i = 0; i < 600; ++i) run(0.5);
    EXPECT_NEAR(day().hour, 6.0, 1e-9);
}

TEST_F(DayCycleTest, StandsWhileItDoesNotRunAndWhileTimeDoesNot) {
    day().hour = 9.0;
    run(1.0);
    const SunAngles before = angles();
    for (int i = 0; i < 100; ++i) run(1.0);
    EXPECT_EQ(day().hour, 9.0);
    day().runs = true;
    for (int i = 0; i < 100; ++i) run(0.0);
    EXPECT_EQ(day().hour, 9.0);
    world.resource<DayPause>().on = true;
    for (int i = 0; i < 100; ++i) run(1.0);
    EXPECT_EQ(day().hour, 9.0);
    EXPECT_EQ(angles().azimuth, before.azimuth);
    EXPECT_EQ(angles().elevation, before.elevation);
}

TEST_F(DayCycleTest, TheSunMovesInSteps) {
    day() = {.runs = true, .hour = 12.0, .minutes = 24.0f, .step = glm::radians(1.0f)};
    run();
    // A degree takes 4 s of a day of 24 minutes.
    std::size_t moves = 0;
    for (int i = 0; i < 4000; ++i) {
        const SunAngles before = angles();
        run(0.01);
        moves += angles().azimuth != before.azimuth ? 1 : 0;
    }
    EXPECT_EQ(moves, 10u);
}

TEST_F(DayCycleTest, WhoTurnsTheSunChangesTheHourAndItGoesOnFromThere) {
    day() = {.runs = true, .hour = 9.0, .minutes = 24.0f, .latitude = 0.7f};
    run(0.1);
    angles() = {.azimuth = 4.0f, .elevation = 0.3f};
    run(0.01);
    // From -pi to pi it is the same place.
    EXPECT_NEAR(std::remainder(angles().azimuth - 4.0f, 2.0f * pi), 0.0f, 1e-3f);
    EXPECT_NEAR(angles().elevation, 0.3f, 1e-3f);
    EXPECT_GT(day().hour, 12.0);
    const double hour = day().hour;
    run(10.0);
    EXPECT_NEAR(day().hour - hour, 10.0 / 60.0, 1e-6);
    EXPECT_LT(angles().elevation, 0.3f);
}

TEST_F(DayCycleTest, WhoSetsTheHourMovesTheSun) {
    run();
    day().hour = 0.0;
    run();
    EXPECT_LT(angles().elevation, 0.0f);
}

TEST_F(DayCycleTest, LightFollowsTheHour) {
    day().hour = 12.0;
    run();
    const float noon = sun_lux(), noon_sky = sky_nit();
    EXPECT_GT(noon, 80000.0f);
    EXPECT_GT(noon_sky, 3000.0f);
    day().hour = 18.2;
    run();
    EXPECT_LT(sun_lux(), 0.5f * noon);
    EXPECT_LT(sky_nit(), 0.6f * noon_sky);
    day().hour = 0.0;
    run();
    EXPECT_LT(sky_nit(), 0.02f);
    EXPECT_GT(sky_nit(), 0.001f);
}

TEST_F(DayCycleTest, ByNightTheMoonShinesFromAbove) {
    day().hour = 0.0;
    run();
    EXPECT_GT(to_light().y, 0.0f);
    EXPECT_LT(angles().elevation, 0.0f);
    EXPECT_NEAR(glm::length(to_light() + -(sun_rotation(angles()) * vec3(0, 0, -1))), 0.0f, 1e-5f);
    const float real = sun_lux();
    EXPECT_GT(real, 0.05f);
    EXPECT_LT(real, 0.32f);
    day().moon = 3.2f;
    run();
    EXPECT_NEAR(sun_lux(), 10.0f * real, 0.01f * real);
    day().moon = 0.0f;
    run();
    EXPECT_EQ(sun_lux(), 0.0f);
}

TEST_F(DayCycleTest, AScenesSunWithoutADayStaysAsItIs) {
    const Entity still = world.create(Transform{}, SunAngles{.azimuth = 1.0f, .elevation = 0.5f}, DirectionalLight{.illuminance = 123.0f});
    day().runs = true;
    for (int i = 0; i < 100; ++i) run(1.0);
    EXPECT_EQ(world.get<SunAngles>(still).azimuth, 1.0f);
    EXPECT_EQ(world.get<DirectionalLight>(still).illuminance, 123.0f);
}

}  // namespace
}  // namespace sl
